package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.Collections;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.apache.commons.math3.util.MathArrays;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Quadrature over wavelengths, meters, ascending: X = sum_i power(lambda_i) weightX_i, Y and Z alike, so that power 1 gives the light's
 * white with Y = 1. Weights are {@code [node][3]}.
 */
public record WavelengthNodes(double[] wavelengths, double[][] weights) {
    /** Relative change of X, Y, Z at which halving ends. At half the step, polynomials of degree 11 err a thousand times less. */
    private static final double CONVERGED = 3e-8;
    // Amplitudes are sums of total magnitude 1 with errors near 1e-15. A power p errs by this times sqrt(p).
    private static final double AMPLITUDE_ROUNDING = 1e-14;
    private static final int MOST_HALVINGS = 6;

    public int count() {
        return wavelengths.length;
    }

    /** Integrates a power, by the wavelength in meters, to X, Y, Z; evaluates it on all processors. */
    public double[] sum(DoubleUnaryOperator power) {
        double[] powers = Arrays.stream(wavelengths).parallel().map(power).toArray();
        double[] sum = new double[3];
        for (int i = 0; i < powers.length; i++) {
            for (int c = 0; c < 3; c++) {
                sum[c] += powers[i] * weights[i][c];
            }
        }
        return sum;
    }

    /**
     * Returns nodes at equal steps, at most as long as wanted, over 380..780 nm with the trapezoid rule, normalized by its sum for Y. For
     * light with lines the steps of 1 / lambda are equal and at most half as long, and the weights integrate the light exactly.
     */
    public static WavelengthNodes uniform(CieTable cie, double stepMeters) {
        if (!cie.isSmooth()) {
            return integrated(cie, 0.5 * stepMeters / (CieTable.MINIMUM_WAVELENGTH * CieTable.MINIMUM_WAVELENGTH));
        }
        double band = CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH;
        int intervals = Math.max(1, (int) Math.ceil(band / stepMeters - 1e-9));
        double[] wavelengths = new double[intervals + 1];
        double[][] weights = new double[intervals + 1][3];
        double sumY = 0;
        for (int i = 0; i <= intervals; i++) {
            wavelengths[i] = CieTable.MINIMUM_WAVELENGTH + band * i / intervals;
            double end = i == 0 || i == intervals ? 0.5 : 1;
            for (int c = 0; c < 3; c++) {
                weights[i][c] = end * cie.at(wavelengths[i], c);
            }
            sumY += weights[i][1];
        }
        for (double[] weight : weights) {
            for (int c = 0; c < 3; c++) {
                weight[c] /= sumY;
            }
        }
        return new WavelengthNodes(wavelengths, weights);
    }

    /**
     * Returns nodes at equal steps of 1 / lambda, 1 / meters, in which orders are equally wide: those of nonzero weight over 380..780 nm
     * and five beyond each end, which the polynomials need.
     */
    public static WavelengthNodes integrated(CieTable cie, double widestStep) {
        return select(new Polynomials(cie, false, widestStep).integrate(), false, 0);
    }

    /** Returns nodes at equal steps of ln lambda, from the first to the last with a weight above {@code leastWeight} times white's. */
    public static WavelengthNodes logarithmic(CieTable cie, double widestStep, double leastWeight) {
        return select(new Polynomials(cie, true, widestStep).integrate(), true, leastWeight);
    }

    private static WavelengthNodes select(WavelengthNodes all, boolean contiguous, double leastWeight) {
        int[] nonzero = IntStream.range(0, all.count())
                .filter(node -> Arrays.stream(all.weights()[node]).anyMatch(weight -> Math.abs(weight) > leastWeight))
                .toArray();
        int[] nodes = contiguous
                ? IntStream.rangeClosed(nonzero[0], nonzero[nonzero.length - 1]).toArray()
                : nonzero;
        return new WavelengthNodes(
                Arrays.stream(nodes).mapToDouble(i -> all.wavelengths()[i]).toArray(),
                Arrays.stream(nodes).mapToObj(i -> all.weights()[i]).toArray(double[][]::new));
    }

    /**
     * Integrates a power, by the wavelength in meters, to X, Y, Z over 380..780 nm and slightly beyond, to nine digits: halves the step of 1 /
     * lambda until the result converges, else throws ArithmeticException. The first step, cycles per meter, resolves the power's structure.
     */
    public static double[] exact(CieTable cie, DoubleUnaryOperator power, double firstStep) {
        double[] coarse = integrated(cie, firstStep).sum(power);
        for (int halving = 1; halving <= MOST_HALVINGS; halving++) {
            double[] fine = integrated(cie, Math.scalb(firstStep, -halving)).sum(power);
            double largest = MathArrays.distanceInf(fine, new double[3]);
            if (MathArrays.distanceInf(fine, coarse)
                    <= CONVERGED * largest + AMPLITUDE_ROUNDING * (Math.sqrt(largest) + AMPLITUDE_ROUNDING)) {
                return fine;
            }
            coarse = fine;
        }
        throw new ArithmeticException("no convergence in steps of " + firstStep + " cycles per meter");
    }

    /**
     * Weights that are exact for color matching functions linear between nanometers, times the polynomial of degree 11 through the powers
     * at neighboring nodes. Weights that only sample these functions err by up to 1e-3 for a narrow blue order: where the functions grow
     * exponentially, chords lie above them.
     */
    private static final class Polynomials {
        // Nodes of a polynomial, and how many of them precede the interval of an integrand.
        private static final int POINTS = 12;
        private static final int BEFORE = POINTS / 2 - 1;
        // Per piece of at most 1 nm and one step, where the integrand is nearly a polynomial.
        private static final int GAUSS_POINTS = 8;

        private final CieTable cie;
        private final boolean logarithmic;
        private final double first;
        private final double step;
        private final int intervals;
        private final double[][] weights;

        Polynomials(CieTable cie, boolean logarithmic, double widestStep) {
            this.cie = cie;
            this.logarithmic = logarithmic;
            this.first = scaled(CieTable.MAXIMUM_WAVELENGTH);
            double range = scaled(CieTable.MINIMUM_WAVELENGTH) - first;
            this.intervals = Math.max(POINTS, (int) Math.ceil(range / widestStep));
            this.step = range / intervals;
            this.weights = new double[intervals + POINTS - 1][3];
        }

        /** Returns a value with equal steps, ascending from the longest wavelength to the shortest. */
        private double scaled(double wavelength) {
            return logarithmic ? -Math.log(wavelength) : 1 / wavelength;
        }

        private double wavelength(double scaled) {
            return logarithmic ? Math.exp(-scaled) : 1 / scaled;
        }

        WavelengthNodes integrate() {
            double[] ends = pieces();
            GaussIntegrator rule = new GaussIntegratorFactory().legendre(GAUSS_POINTS);
            for (int piece = 0; piece + 1 < ends.length; piece++) {
                double half = 0.5 * (ends[piece + 1] - ends[piece]);
                double middle = 0.5 * (ends[piece + 1] + ends[piece]);
                for (int g = 0; g < GAUSS_POINTS; g++) {
                    add(middle + half * rule.getPoint(g), half * rule.getWeight(g) / cie.integralOfY());
                }
            }
            double[] wavelengths = new double[weights.length];
            Arrays.setAll(wavelengths, i -> wavelength(first + (weights.length - 1 - i - BEFORE) * step));
            Collections.reverse(Arrays.asList(weights));
            return new WavelengthNodes(wavelengths, weights);
        }

        /** The integrand has kinks at the table's wavelengths and at the nodes. */
        private double[] pieces() {
            int knots = (int) Math.round((CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) * 1e9);
            DoubleStream table =
                    IntStream.rangeClosed(0, knots).mapToDouble(i -> CieTable.MINIMUM_WAVELENGTH + i * 1e-9);
            DoubleStream nodes = IntStream.range(1, intervals).mapToDouble(i -> wavelength(first + i * step));
            return DoubleStream.concat(table, nodes).sorted().toArray();
        }

        private void add(double wavelength, double length) {
            double position = (scaled(wavelength) - first) / step;
            int interval = (int) Math.max(0, Math.min(intervals - 1.0, Math.floor(position)));
            double fraction = position - interval;
            double[] matching = {cie.at(wavelength, 0), cie.at(wavelength, 1), cie.at(wavelength, 2)};
            for (int k = 0; k < POINTS; k++) {
                double share = length * Lagrange.weight(fraction + BEFORE, k, POINTS);
                for (int c = 0; c < 3; c++) {
                    weights[interval + k][c] += share * matching[c];
                }
            }
        }
    }
}
