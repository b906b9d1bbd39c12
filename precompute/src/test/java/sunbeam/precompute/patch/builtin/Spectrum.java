package sunbeam.precompute.patch.builtin;

import org.jtransforms.fft.DoubleFFT_2D;
import sunbeam.precompute.optics.HeightMap;

/** Power spectrum of a patch's heights. */
final class Spectrum {
    private final int columns;
    private final int rows;
    private final double[] power;

    /** The mean is removed. The powers of all bins sum to the mean square. */
    Spectrum(HeightMap patch) {
        columns = patch.columns();
        rows = patch.rows();
        double[] heights = patch.heights();
        double mean = 0;
        for (double height : heights) {
            mean += height / heights.length;
        }
        double[] data = new double[2 * heights.length];
        for (int i = 0; i < heights.length; i++) {
            data[2 * i] = heights[i] - mean;
        }
        new DoubleFFT_2D(rows, columns).complexForward(data);
        power = new double[heights.length];
        for (int i = 0; i < power.length; i++) {
            double size = heights.length;
            power[i] = (data[2 * i] * data[2 * i] + data[2 * i + 1] * data[2 * i + 1]) / (size * size);
        }
    }

    /** Selects bins by their signed numbers of periods across the patch, q downwards. */
    @FunctionalInterface
    interface Bins {
        boolean contains(int p, int q);
    }

    /** Receives each bin's signed numbers of periods and its mean square. */
    @FunctionalInterface
    interface Visitor {
        void visit(int p, int q, double meanSquare);
    }

    void forEach(Visitor visitor) {
        for (int row = 0; row < rows; row++) {
            int q = signed(row, rows);
            for (int column = 0; column < columns; column++) {
                visitor.visit(signed(column, columns), q, power[row * columns + column]);
            }
        }
    }

    /** Mean square of the heights in these bins. */
    double meanSquare(Bins bins) {
        double[] sum = new double[1];
        forEach((p, q, meanSquare) -> sum[0] += bins.contains(p, q) ? meanSquare : 0);
        return sum[0];
    }

    /** Mean squares of these bins by their absolute number of periods along x. */
    double[] byP(Bins bins) {
        double[] sums = new double[columns / 2 + 1];
        forEach((p, q, meanSquare) -> sums[Math.abs(p)] += bins.contains(p, q) ? meanSquare : 0);
        return sums;
    }

    /** Mean squares of these bins by their absolute number of periods along y. */
    double[] byQ(Bins bins) {
        double[] sums = new double[rows / 2 + 1];
        forEach((p, q, meanSquare) -> sums[Math.abs(q)] += bins.contains(p, q) ? meanSquare : 0);
        return sums;
    }

    /** Root of {@link #meanSquare}. */
    double rms(Bins bins) {
        return Math.sqrt(meanSquare(bins));
    }

    private static int signed(int bin, int size) {
        return bin <= size / 2 ? bin : bin - size;
    }
}
