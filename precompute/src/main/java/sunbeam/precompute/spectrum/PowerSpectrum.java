package sunbeam.precompute.spectrum;

import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Power spectrum of a surface: |F_j|^2 of its DFT bins as a short sum of terms, each a function of the phase zeta times one value per bin.
 * Built once per surface; each user applies its own window. {@code exchanged} holds the spectrum with x and y exchanged, once it
 * is made: it is as large, and all open bakers of a table use it. Powers are {@code [row][column][term]}, not to be changed. Thread-safe.
 */
public record PowerSpectrum(
        HeightScale scale,
        CoefficientTable coefficients,
        Axis x,
        Axis y,
        double[] powers,
        double tolerance,
        AtomicReference<PowerSpectrum> exchanged) {
    /** Largest angular frequency of a power over the phase: two scaled heights, both in -1..1, differ by at most 2. */
    public static final double BANDWIDTH = 2;

    public static final int TOGETHER = 4;
    private static final int POINTS = 8;
    private static final int BEFORE = POINTS / 2 - 1;

    /** Bins along one axis: bin i has the frequency (first + i) / period; the period, meters, is the surface's extent unless decimated. */
    public record Axis(double period, int first, int count) {
        public int last() {
            return first + count - 1;
        }

        public double place(double frequency) {
            return frequency * period - first;
        }
    }

    private PowerSpectrum(
            HeightScale scale, CoefficientTable coefficients, Axis x, Axis y, double[] powers, double tolerance) {
        this(scale, coefficients, x, y, powers, tolerance, new AtomicReference<>());
    }

    /** Returns a surface's spectrum with a relative root-mean-square error of the powers over an octave of phases. */
    public static PowerSpectrum of(FourierTable table, double tolerance) {
        PowerBasis basis = new PowerBasis(table, tolerance);
        return of(table.expansion().scale(), basis.coefficients(), table.x(), table.y(), basis.projections, tolerance);
    }

    /** Returns a spectrum of terms {@code [term][bin]}. */
    public static PowerSpectrum of(
            HeightScale scale, CoefficientTable coefficients, Axis x, Axis y, double[][] terms, double tolerance) {
        int stride = (terms.length + TOGETHER - 1) / TOGETHER * TOGETHER;
        double[] powers = new double[Math.multiplyExact(stride, Math.multiplyExact(x.count, y.count))];
        IntStream.range(0, x.count * y.count).parallel().forEach(bin -> {
            for (int m = 0; m < terms.length; m++) {
                powers[bin * stride + m] = terms[m][bin];
            }
        });
        return new PowerSpectrum(scale, coefficients, x, y, powers, tolerance);
    }

    /** Returns the number of values per bin: the terms, padded with zeros. */
    public int stride() {
        return powers.length / (x.count * y.count);
    }

    /** Returns the values of some terms, {@code [term - first][bin]}. */
    public double[][] terms(int first, int end) {
        double[][] terms = new double[end - first][x.count * y.count];
        for (int bin = 0; bin < terms[0].length; bin++) {
            for (int m = first; m < end; m++) {
                terms[m - first][bin] = powers[bin * stride() + m];
            }
        }
        return terms;
    }

    /** Returns the terms' coefficients at a wavelength in meters; phases beyond those of the surface's plan are clamped to them. */
    public double[] coefficients(double wavelength, double absoluteW) {
        return coefficients.at(scale.phase(wavelength, absoluteW));
    }

    /** Returns the spectrum with x and y exchanged, made on first use; two threads may make it, neither waits. */
    public PowerSpectrum transposed() {
        PowerSpectrum known = exchanged.get();
        if (known != null) {
            return known;
        }
        double[] target = new double[powers.length];
        int stride = stride();
        IntStream.range(0, x.count).parallel().forEach(column -> {
            for (int row = 0; row < y.count; row++) {
                int from = (row * x.count + column) * stride;
                System.arraycopy(powers, from, target, (column * y.count + row) * stride, stride);
            }
        });
        known = new PowerSpectrum(scale, coefficients, y, x, target, tolerance);
        known.exchanged.set(this);
        exchanged.set(known);
        return known;
    }

    /**
     * Returns bins that are farther apart by whole factors, by at most a spacing in cycles per meter. Lagrange weights of degree 7 distribute
     * each power over eight bins, so that sums over Gaussians wider than the new spacing do not change.
     */
    public PowerSpectrum decimated(double spacing) {
        int factorX = (int) Math.max(1, spacing * x.period);
        int factorY = (int) Math.max(1, spacing * y.period);
        PowerSpectrum alongX = factorX == 1 ? this : decimatedX(factorX);
        return factorY == 1 ? alongX : alongX.transposed().decimatedX(factorY).transposed();
    }

    private PowerSpectrum decimatedX(int factor) {
        int first = Math.floorDiv(x.first, factor) - BEFORE;
        int count = Math.floorDiv(x.last(), factor) + POINTS - BEFORE - first + 1;
        int stride = stride();
        double[] sums = new double[Math.multiplyExact(Math.multiplyExact(y.count, count), stride)];
        double[][] weights = IntStream.range(0, factor)
                .mapToObj(rest -> IntStream.range(0, POINTS)
                        .mapToDouble(k -> Lagrange.weight((double) rest / factor + BEFORE, k, POINTS))
                        .toArray())
                .toArray(double[][]::new);
        IntStream.range(0, y.count).parallel().forEach(row -> {
            for (int column = 0; column < x.count; column++) {
                int below = Math.floorDiv(x.first + column, factor);
                double[] shares = weights[Math.floorMod(x.first + column, factor)];
                for (int k = 0; k < POINTS; k++) {
                    int to = (row * count + below - BEFORE + k - first) * stride;
                    int from = (row * x.count + column) * stride;
                    for (int m = 0; m < stride; m++) {
                        sums[to + m] += shares[k] * powers[from + m];
                    }
                }
            }
        });
        return new PowerSpectrum(scale, coefficients, new Axis(x.period / factor, first, count), y, sums, tolerance);
    }
}
