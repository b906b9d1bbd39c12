package sunbeam.app.cli.render;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.correlation.PearsonsCorrelation;
import sunbeam.app.render.PixelPicture.LitPixels;
import sunbeam.app.render.ScenePicture;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.text.Text;

/**
 * Comparison of a photograph with a scene of the same size, over all pixels that the mesh covers and that are opaque in the photograph.
 * Exposure and correlations leave out pixels that are clipped in the photograph.
 *
 * @param exposure factor by which the scene's X, Y, Z match the photograph's
 * @param covered number of compared pixels, some of them clipped
 * @param differences CIEDE2000 of each pixel, row by row; NaN if a pixel is not compared
 * @param high 95th percentile of the differences
 * @param luminance Pearson's correlation of the luminances; NaN if one is constant
 */
record PhotoComparison(
        double exposure,
        int covered,
        int clipped,
        double[] differences,
        double median,
        double high,
        double luminance,
        HueComparison hue,
        LitPixels lit) {
    /** Least coverage of a fully covered pixel, which is 1 but for rounding. */
    private static final float WHOLE = 0.999f;
    /** Error, in standard deviations, above which Huber's weights fall: 95 % efficient for normal errors (P. Huber, 1964). */
    private static final double HUBER = 1.345;
    /** Ratio of the standard deviation of normal errors to the median of their absolute values. */
    private static final double DEVIATION = 1.4826;
    // Largest linear luminance of a photograph that counts as black: just above the first step of 8 bits, 3e-4.
    private static final double DARKEST = 4e-4;
    private static final int MOST_STEPS = 50;

    static PhotoComparison of(Photograph.Linear photo, ScenePicture scene, Optional<Double> given) {
        float[] seen = photo.picture().rgba();
        float[] drawn = scene.rgba();
        int[] covered = IntStream.range(0, photo.clipped().length)
                .filter(pixel -> drawn[4 * pixel + 3] > WHOLE && seen[4 * pixel + 3] > WHOLE)
                .toArray();
        int[] fitted =
                Arrays.stream(covered).filter(pixel -> !photo.clipped()[pixel]).toArray();
        InputException.refuseIf(
                fitted.length == 0,
                covered.length == 0
                        ? "the scene's mesh covers no opaque pixel of the photograph; change the scene's camera, or the mask"
                        : "the photograph is clipped wherever the mesh is; take one of shorter exposure");
        double[] photoY = luminances(seen, fitted);
        double[] sceneY = luminances(drawn, fitted);
        double exposure = given.orElseGet(() -> exposure(sceneY, photoY));
        boolean isBlack = Arrays.stream(photoY).noneMatch(y -> y > DARKEST);
        InputException.refuseIf(
                isBlack || !(exposure > 0) || !Double.isFinite(exposure),
                "photograph or scene is black where the mesh is; change the scene's light or weights");
        List<CieLab> photoColors = colors(seen, covered, 1);
        List<CieLab> sceneColors = colors(drawn, covered, exposure);
        double[] differences = new double[photo.clipped().length];
        Arrays.fill(differences, Double.NaN);
        double[] compared = new double[covered.length];
        for (int i = 0; i < covered.length; i++) {
            compared[i] = photoColors.get(i).difference(sceneColors.get(i));
            differences[covered[i]] = compared[i];
        }
        return new PhotoComparison(
                exposure,
                covered.length,
                covered.length - fitted.length,
                differences,
                Quantiles.of(compared, 0.5),
                Quantiles.of(compared, 0.95),
                fitted.length < 2 ? Double.NaN : new PearsonsCorrelation().correlation(photoY, sceneY),
                HueComparison.of(colors(seen, fitted, 1), colors(drawn, fitted, exposure)),
                LitPixels.of(scene, display(exposure)));
    }

    /** Fits the factor f of y = f x by least squares with Huber's weights, so that a few glints do not decide. */
    static double exposure(double[] x, double[] y) {
        double[] weights = new double[x.length];
        Arrays.fill(weights, 1);
        double factor = 0;
        for (int step = 0; step < MOST_STEPS; step++) {
            double before = factor;
            double products = 0;
            double squares = 0;
            for (int i = 0; i < x.length; i++) {
                products += weights[i] * x[i] * y[i];
                squares += weights[i] * x[i] * x[i];
            }
            factor = products / squares;
            double fitted = factor;
            double[] errors = IntStream.range(0, x.length)
                    .mapToDouble(i -> Math.abs(y[i] - fitted * x[i]))
                    .toArray();
            double limit = HUBER * DEVIATION * Quantiles.of(errors, 0.5);
            Arrays.setAll(weights, i -> errors[i] > limit ? limit / errors[i] : 1);
            if (limit == 0 || Math.abs(factor - before) <= 1e-9 * factor) {
                break;
            }
        }
        return factor;
    }

    private static DisplayTransform display(double exposure) {
        return new DisplayTransform(exposure, Tone.CLIP);
    }

    private static double[] luminances(float[] rgba, int[] pixels) {
        return Arrays.stream(pixels).mapToDouble(pixel -> rgba[4 * pixel + 1]).toArray();
    }

    private static List<CieLab> colors(float[] rgba, int[] pixels, double exposure) {
        DisplayTransform display = display(exposure);
        return Arrays.stream(pixels)
                .parallel()
                .mapToObj(pixel -> {
                    double[] light = new double[3];
                    display.light(rgba, 4 * pixel, light);
                    double[] xyz = Srgb.xyz(light[0], light[1], light[2]);
                    return CieLab.ofXyz(xyz[0], xyz[1], xyz[2]);
                })
                .toList();
    }

    List<String> lines() {
        return List.of(
                Text.format("exposure: %.4g, the photograph's luminance over the scene's", exposure),
                Text.format(
                        "compared: %d pixels of the mesh, not its ground; %.2g %% of them clipped in the photograph",
                        covered, 100.0 * clipped / covered),
                Text.format("CIEDE2000: median %.3g, 95th percentile %.3g", median, high),
                "luminance: " + correlation(luminance),
                hue.line(),
                lit.summary());
    }

    static String correlation(double value) {
        return Double.isNaN(value) ? "no correlation, as one is constant" : Text.format("correlation %.3f", value);
    }

    Map<String, Object> values() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("exposure", exposure);
        values.put("covered_pixels", covered);
        values.put("clipped_share", (double) clipped / covered);
        values.put("ciede2000_median", median);
        values.put("ciede2000_percentile_95", high);
        values.put("luminance_correlation", luminance);
        values.put("hue_correlation", hue.correlation());
        values.put("hue_turn_deg", hue.turnDegrees());
        values.put("hue_pixels", hue.count());
        values.put("lit_share", lit.share());
        return values;
    }

    /**
     * Comparison of hues, the angle h of CIE 1976 L*a*b*, over the pairs of colors that both have one; NaN without them.
     *
     * @param correlation circular correlation (S. R. Jammalamadaka and A. SenGupta, "Topics in Circular Statistics", 2001, 8.2), -1 to 1
     * @param turnDegrees mean angle from the first hue to the second, degrees
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
            double oneMean = mean(colored, i -> hue(first.get(i)));
            double otherMean = mean(colored, i -> hue(second.get(i)));
            double products = 0;
            double oneSquares = 0;
            double otherSquares = 0;
            for (int i : colored) {
                double a = Math.sin(hue(first.get(i)) - oneMean);
                double b = Math.sin(hue(second.get(i)) - otherMean);
                products += a * b;
                oneSquares += a * a;
                otherSquares += b * b;
            }
            return new HueComparison(
                    colored.length,
                    products / Math.sqrt(oneSquares * otherSquares),
                    Math.toDegrees(mean(colored, i -> hue(second.get(i)) - hue(first.get(i)))),
                    histogram(first),
                    histogram(second));
        }

        private static boolean isColored(CieLab color) {
            return color.chroma() >= LEAST_CHROMA;
        }

        private static double hue(CieLab color) {
            return Math.atan2(color.b(), color.a());
        }

        private static double mean(int[] colors, IntToDoubleFunction angle) {
            double x = 0;
            double y = 0;
            for (int color : colors) {
                x += Math.cos(angle.applyAsDouble(color));
                y += Math.sin(angle.applyAsDouble(color));
            }
            return colors.length == 0 ? Double.NaN : Math.atan2(y, x);
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
}
