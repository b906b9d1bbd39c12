package sunbeam.app.cli.compare;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.text.Text;

/**
 * Comparison of hues, the angle h of CIE 1976 L*a*b*, over pairs of colors.
 *
 * @param count number of pairs in which both colors have a hue
 * @param correlation circular correlation of the hues (S. R. Jammalamadaka and A. SenGupta, "Topics in Circular Statistics", 2001, 8.2), -1
 *     to 1; NaN if one hue is constant
 * @param turnDegrees mean angle from the first hue to the second, degrees; NaN without pairs
 * @param first histogram of the first hues: share of all colors in each step of {@link #STEP_DEGREES} from 0
 */
record HueComparison(int count, double correlation, double turnDegrees, double[] first, double[] second) {
    static final int STEP_DEGREES = 10;
    /** Least chroma of a color that has a hue; below it noise decides. */
    static final double LEAST_CHROMA = 10;

    static HueComparison of(List<CieLab> first, List<CieLab> second) {
        int[] colored = IntStream.range(0, first.size())
                .filter(i -> isColored(first.get(i)) && isColored(second.get(i)))
                .toArray();
        double[] one = IntStream.of(colored).mapToDouble(i -> hue(first.get(i))).toArray();
        double[] other =
                IntStream.of(colored).mapToDouble(i -> hue(second.get(i))).toArray();
        double[] turns = IntStream.range(0, colored.length)
                .mapToDouble(i -> other[i] - one[i])
                .toArray();
        double oneMean = mean(one);
        double otherMean = mean(other);
        double products = 0;
        double oneSquares = 0;
        double otherSquares = 0;
        for (int i = 0; i < colored.length; i++) {
            double a = Math.sin(one[i] - oneMean);
            double b = Math.sin(other[i] - otherMean);
            products += a * b;
            oneSquares += a * a;
            otherSquares += b * b;
        }
        return new HueComparison(
                colored.length,
                products / Math.sqrt(oneSquares * otherSquares),
                Math.toDegrees(mean(turns)),
                histogram(first),
                histogram(second));
    }

    private static boolean isColored(CieLab color) {
        return color.chroma() >= LEAST_CHROMA;
    }

    private static double hue(CieLab color) {
        return Math.atan2(color.b(), color.a());
    }

    private static double mean(double[] angles) {
        double x = 0;
        double y = 0;
        for (double angle : angles) {
            x += Math.cos(angle);
            y += Math.sin(angle);
        }
        return angles.length == 0 ? Double.NaN : Math.atan2(y, x);
    }

    private static double[] histogram(List<CieLab> colors) {
        double[] shares = new double[360 / STEP_DEGREES];
        colors.stream().filter(HueComparison::isColored).forEach(color -> {
            int step = (int) (Math.toDegrees(hue(color)) + 360) % 360 / STEP_DEGREES;
            shares[step] += 1.0 / colors.size();
        });
        return shares;
    }

    String line() {
        if (count < 2) {
            return "hue: photograph and scene have too few pixels that are both colored";
        }
        return Text.format(
                "hue: %s; the scene's is turned by %.2g degrees, over %d pixels of chroma %.0f or more in both",
                PhotoComparison.correlation(correlation), turnDegrees, count, LEAST_CHROMA);
    }
}
