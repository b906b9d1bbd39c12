package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Computes quadrature nodes at equal steps of 1 / lambda, in which diffraction orders are equally wide, or of ln lambda. The weights are
 * exact for color matching functions that are linear between whole nanometers, times the polynomial of degree 11 through the powers at
 * neighboring nodes. Weights that only sample these functions err by up to 1e-3 for a narrow blue order: where the functions grow
 * exponentially, chords lie above them.
 */
public final class IntegratedNodes {
    // Nodes of a polynomial, and how many of them precede the interval of an integrand.
    private static final int POINTS = 12;
    private static final int BEFORE = POINTS / 2 - 1;
    // Per piece of at most 1 nm and one step, where the integrand is nearly a polynomial.
    private static final int GAUSS_POINTS = 8;

    /** Scale with equal steps, ascending from the longest wavelength to the shortest, and its inverse. */
    private record Scale(DoubleUnaryOperator of, DoubleUnaryOperator wavelength) {
        static final Scale WAVE_NUMBER = new Scale(wavelength -> 1 / wavelength, value -> 1 / value);
        static final Scale LOGARITHM = new Scale(wavelength -> -Math.log(wavelength), value -> Math.exp(-value));

        double of(double length) {
            return of.applyAsDouble(length);
        }

        double wavelength(double value) {
            return wavelength.applyAsDouble(value);
        }
    }

    private final CieTable cie;
    private final Scale scale;
    private final double first;
    private final double step;
    private final int intervals;
    private final double[][] weights;

    private IntegratedNodes(CieTable cie, Scale scale, double widestStep) {
        double low = scale.of(CieTable.MAXIMUM_WAVELENGTH);
        double high = scale.of(CieTable.MINIMUM_WAVELENGTH);
        this.cie = cie;
        this.scale = scale;
        this.first = low;
        this.intervals = Math.max(POINTS, (int) Math.ceil((high - low) / widestStep));
        this.step = (high - low) / intervals;
        this.weights = new double[intervals + POINTS - 1][3];
    }

    /**
     * Returns the nodes of nonzero weight over 380..780 nm and five beyond each end, which the polynomials need.
     *
     * @param widestStep largest step of 1 / lambda, in cycles per meter
     */
    public static WavelengthNodes of(CieTable cie, double widestStep) {
        return select(new IntegratedNodes(cie, Scale.WAVE_NUMBER, widestStep).integrate(), false, 0);
    }

    /** Returns nodes at equal steps of ln lambda, from the first to the last of nonzero weight. */
    public static WavelengthNodes logarithmic(CieTable cie, double widestStep) {
        return logarithmic(cie, widestStep, 0);
    }

    /** Returns nodes at equal steps of ln lambda, from the first to the last with a weight above {@code leastWeight} times white's. */
    public static WavelengthNodes logarithmic(CieTable cie, double widestStep, double leastWeight) {
        return select(new IntegratedNodes(cie, Scale.LOGARITHM, widestStep).integrate(), true, leastWeight);
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

    private WavelengthNodes integrate() {
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
        double[][] ascending = new double[weights.length][];
        for (int i = 0; i < weights.length; i++) {
            int node = weights.length - 1 - i;
            wavelengths[i] = scale.wavelength(first + (node - BEFORE) * step);
            ascending[i] = weights[node];
        }
        return new WavelengthNodes(wavelengths, ascending);
    }

    /** The integrand has kinks at the table's wavelengths and at the nodes. */
    private double[] pieces() {
        int knots = (int) Math.round((CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) * 1e9);
        DoubleStream table = IntStream.rangeClosed(0, knots).mapToDouble(i -> CieTable.MINIMUM_WAVELENGTH + i * 1e-9);
        DoubleStream nodes = IntStream.range(1, intervals).mapToDouble(i -> scale.wavelength(first + i * step));
        double[] ends = DoubleStream.concat(table, nodes).toArray();
        Arrays.sort(ends);
        return ends;
    }

    private void add(double wavelength, double length) {
        double position = (scale.of(wavelength) - first) / step;
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
