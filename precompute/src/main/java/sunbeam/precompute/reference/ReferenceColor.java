package sunbeam.precompute.reference;

import java.util.function.DoubleUnaryOperator;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ExactIntegral;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightLevels;

/** X, Y, Z of the reference's power over 380..780 nm. */
public record ReferenceColor(
        ReferenceEvaluator evaluator, CoherenceWindow window, CieTable cie, Quadrature quadrature) {
    // Steps of 1 / lambda for polynomials of degree 11, set by comparison with steps of 0.5 pm for orders of all widths
    // anywhere in the band: 0.7 deviations of an order's power, and not above what the color matching functions need
    // (cycles per metre; 2 nm in the blue, 7 nm in the red). Error 5e-9 median, 5e-7 at most.
    private static final double NODES_PER_DEVIATION = 1 / 0.7;
    private static final double WIDEST_STEP = 12e3;
    // Nodes per period of the interference between top and bottom of the relief.
    private static final double NODES_PER_FRINGE = 8;

    /** Quadrature of power against the color matching functions. */
    public enum Quadrature {
        /** Halved until X, Y, Z keep nine digits ({@link ExactIntegral}). */
        EXACT,
        /** One pass ({@link IntegratedNodes}) in smooth light: three times as fast, accurate to 1e-6. */
        INTEGRATED
    }

    /** Integrates to nine digits. */
    public ReferenceColor(ReferenceEvaluator evaluator, CoherenceWindow window, CieTable cie) {
        this(evaluator, window, cie, Quadrature.EXACT);
    }

    private double step(DirectionPair pair) {
        return step(window, evaluator.heights(), Math.hypot(pair.u(), pair.v()), Math.abs(pair.w()));
    }

    /**
     * Returns the step of 1 / lambda, in 1 / meters, that resolves the power in a direction: an order is sigma_f / (sqrt 2 |(u, v)|) wide
     * in 1 / lambda.
     *
     * @param uv length of (u, v)
     * @param w magnitude of w
     */
    public static double step(CoherenceWindow window, HeightLevels heights, double uv, double w) {
        double deviation = window.sigmaFrequency() / (Math.sqrt(2) * Math.max(1e-9, uv));
        double fringes = w * (heights.maximum() - heights.minimum());
        // Products of oscillations have the sum of their bandwidths.
        return 1 / (NODES_PER_DEVIATION / deviation + NODES_PER_FRINGE * fringes + 1 / WIDEST_STEP);
    }

    /** Returns nodes that are dense enough for a direction, with weights that integrate the color matching functions. */
    public WavelengthNodes nodes(DirectionPair pair) {
        return IntegratedNodes.of(cie, step(pair));
    }

    /**
     * Returns X, Y, Z of the power, without any gain.
     *
     * @param ensemble true for the mean over all positions of the window
     */
    public double[] xyz(DirectionPair pair, boolean ensemble) {
        DoubleUnaryOperator power = ensemble
                ? wavelength -> evaluator.powers(pair, wavelength).ensemble()
                : wavelength -> evaluator.coherent(pair, wavelength);
        // Monochromatic light needs the exact quadrature: on the flanks of orders, a millionth of their maximum is a
        // large relative error.
        return quadrature == Quadrature.EXACT || !cie.isSmooth()
                ? ExactIntegral.xyz(cie, power, step(pair))
                : nodes(pair).sum(power);
    }
}
