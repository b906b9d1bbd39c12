package sunbeam.app.promise;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform2d;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.VisibleRange;

/**
 * The color of coherent power as a polynomial in w, after D. Dhillon, J. Teyssier, M. Single, I. Gaponenko, M. Milinkovitch
 * and M. Zwicker, "Interactive Diffraction from Biological Nanostructures", Computer Graphics Forum 33 (2014): with exp(i k w h) = sum_n
 * (i k w h)^n / n!,
 *
 * <pre>C(u, v, w) = sum_{r = 0}^{2 N} w^r sum_{n + m = r} int k^r / (n! m!) Re(i^n conj(i^m) G_n conj(G_m)) xyz dlambda</pre>
 *
 * <p>G_n is the windowed spectrum of h^n. Everything is in double precision: bins of the DFT of h^n under all of the window's
 * Gaussian. Heights are centred on the middle of their range and w is counted in units of 2, which keeps the series' terms as
 * small as they can be.
 */
final class TaylorSeries {
    // Deviations of the window's spectrum beyond which nothing is left of it in double precision but 1e-8.
    private static final double REACH = 6;

    private final HeightScale scale;
    private final CoherenceWindow window;
    private final Band bandX;
    private final Band bandY;
    private final double width;
    private final double height;
    private final double[][] real;
    private final double[][] imaginary;

    /**
     * Transforms powers of the heights.
     *
     * @param most largest N that will be asked for
     */
    TaylorSeries(HeightLevels heights, CoherenceWindow window, int most) {
        this.scale = HeightScale.midRange(heights);
        this.window = window;
        this.width = heights.map().width();
        this.height = heights.map().height();
        VisibleRange range = VisibleRange.of(new Direction(0, 0, 1));
        this.bandX = range.bandX(width, bins(width) + 1);
        this.bandY = range.bandY(height, bins(height) + 1);
        this.real = new double[most + 1][];
        this.imaginary = new double[most + 1][];
        transform(heights);
    }

    private int bins(double period) {
        return (int) Math.ceil(REACH * window.sigmaFrequency() * period);
    }

    private void transform(HeightLevels heights) {
        int columns = heights.map().columns();
        int rows = heights.map().rows();
        BandTransform2d transform = new BandTransform2d(columns, rows, bandX, bandY);
        double[][] alongX = bandX.phases(columns, -WindowOrigin.CENTRE.sample(columns));
        // Rows run downwards, y upwards.
        double[][] alongY = bandY.phases(rows, WindowOrigin.CENTRE.sample(rows));
        int[] index = heights.index();
        double[] scaled = new double[heights.count()];
        double[] power = new double[heights.count()];
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] = scale.scaled(heights.levels()[i]);
            power[i] = 1;
        }
        for (int n = 0; n < real.length; n++) {
            double[] term = power.clone();
            ComplexVector bins = transform.transform((row, re, im) -> {
                for (int column = 0; column < columns; column++) {
                    re[column] = term[index[row * columns + column]];
                }
            });
            turn(bins, alongX, alongY);
            real[n] = bins.real();
            imaginary[n] = bins.imaginary();
            for (int i = 0; i < power.length; i++) {
                power[i] *= scaled[i];
            }
        }
    }

    /** Moves the origin of phases to the window's maximum. */
    private void turn(ComplexVector bins, double[][] alongX, double[][] alongY) {
        int columns = bandX.count();
        for (int i = 0; i < bins.length(); i++) {
            int x = i % columns;
            int y = i / columns;
            double cosine = alongX[0][x] * alongY[0][y] - alongX[1][x] * alongY[1][y];
            double sine = alongX[0][x] * alongY[1][y] + alongX[1][x] * alongY[0][y];
            double re = bins.real()[i];
            double im = bins.imaginary()[i];
            bins.real()[i] = re * cosine - im * sine;
            bins.imaginary()[i] = re * sine + im * cosine;
        }
    }

    /**
     * What a table would have at a place: X, Y, Z of the coefficient of (|w| / 2)^r.
     *
     * @param largestN the N that are wanted
     * @param nodes at which the spectrum is integrated
     * @return for each N its 2 N + 1 coefficients
     */
    List<double[][]> coefficients(double u, double v, WavelengthNodes nodes, List<Integer> largestN) {
        List<double[][]> all = new ArrayList<>();
        largestN.forEach(n -> all.add(new double[2 * n + 1][3]));
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            double[][] terms = terms(u / wavelength, v / wavelength, scale.phase(wavelength, 2));
            for (double[][] each : all) {
                add(each, terms, nodes.weights()[i]);
            }
        }
        return all;
    }

    /** (-i zeta)^n / n! G_n at a frequency: real and imaginary parts; |w| is w's unit here, whose phase is zeta. */
    private double[][] terms(double fx, double fy, double zeta) {
        double[][] terms = new double[real.length][2];
        int middleX = (int) Math.rint(fx * width);
        int middleY = (int) Math.rint(fy * height);
        for (int y = middleY - bins(height); y <= middleY + bins(height); y++) {
            for (int x = middleX - bins(width); x <= middleX + bins(width); x++) {
                boolean inBand = x >= bandX.first() && x <= bandX.last() && y >= bandY.first() && y <= bandY.last();
                if (inBand) {
                    double distance = Math.hypot(fx - x / width, fy - y / height) / window.sigmaFrequency();
                    gather(
                            terms,
                            (y - bandY.first()) * bandX.count() + x - bandX.first(),
                            Math.exp(-0.5 * distance * distance));
                }
            }
        }
        double factor = 1;
        for (int n = 0; n < terms.length; n++) {
            turnBack(terms[n], n, factor);
            factor *= zeta / (n + 1);
        }
        return terms;
    }

    private void gather(double[][] terms, int bin, double weight) {
        for (int n = 0; n < terms.length; n++) {
            terms[n][0] += weight * real[n][bin];
            terms[n][1] += weight * imaginary[n][bin];
        }
    }

    /** Times (-i)^n and a factor: w is negative. */
    private static void turnBack(double[] term, int n, double factor) {
        double re = term[0] * factor;
        double im = term[1] * factor;
        switch (n % 4) {
            case 0 -> set(term, re, im);
            case 1 -> set(term, im, -re);
            case 2 -> set(term, -re, -im);
            default -> set(term, -im, re);
        }
    }

    private static void set(double[] term, double re, double im) {
        term[0] = re;
        term[1] = im;
    }

    private static void add(double[][] coefficients, double[][] terms, double... weights) {
        int most = (coefficients.length - 1) / 2;
        for (int n = 0; n <= most; n++) {
            for (int m = 0; m <= most; m++) {
                double product = terms[n][0] * terms[m][0] + terms[n][1] * terms[m][1];
                for (int c = 0; c < 3; c++) {
                    coefficients[n + m][c] += weights[c] * product;
                }
            }
        }
    }

    /** X, Y, Z at a w by tables of double precision. */
    static double[] inDouble(double[][] coefficients, double w) {
        double half = Math.abs(w) / 2;
        double[] xyz = new double[3];
        for (int r = coefficients.length - 1; r >= 0; r--) {
            for (int c = 0; c < 3; c++) {
                xyz[c] = xyz[c] * half + coefficients[r][c];
            }
        }
        return xyz;
    }

    /** X, Y, Z at a w as a graphics card computes it: tables and sums of float32. */
    static double[] inFloat(double[][] coefficients, double w) {
        float half = (float) (Math.abs(w) / 2);
        float[] xyz = new float[3];
        for (int r = coefficients.length - 1; r >= 0; r--) {
            for (int c = 0; c < 3; c++) {
                xyz[c] = xyz[c] * half + (float) coefficients[r][c];
            }
        }
        return IntStream.range(0, 3).mapToDouble(c -> xyz[c]).toArray();
    }
}
