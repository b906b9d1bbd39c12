package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/** Exact diffracted power under the Gaussian coherence window of its evaluator, or its mean over all positions of the window. */
public record WindowLight(ReferenceEvaluator evaluator, CieTable cie, boolean ensemble) implements ExactLight {
    // Steps for polynomials of degree 11: 0.7 standard deviations of an order's power. The color matching functions
    // need 12e3
    // cycles per meter at most (2 nm in the blue, 7 nm in the red). Compared with steps of 0.5 pm, the median error is
    // 5e-9, the largest 5e-7.
    private static final double NODES_PER_DEVIATION = 1 / 0.7;
    static final double WIDEST_STEP = 12e3;
    // Per period of the interference between top and bottom of the relief.
    private static final double NODES_PER_FRINGE = 8;

    /** Returns the step of 1 / lambda, 1 / meters, that resolves the power; an order deviates by sigma_f / (sqrt 2 |(u, v)|). */
    public static double step(CoherenceWindow window, HeightLevels heights, double uv, double w) {
        double deviation = window.sigmaFrequency() / (Math.sqrt(2) * Math.max(1e-9, uv));
        double fringes = w * (heights.maximum() - heights.minimum());
        // The bandwidth of a product is the sum of its factors' bandwidths.
        return 1 / (NODES_PER_DEVIATION / deviation + NODES_PER_FRINGE * fringes + 1 / WIDEST_STEP);
    }

    private double step(DirectionPair pair) {
        return step(window(), evaluator.heights(), Math.hypot(pair.u(), pair.v()), Math.abs(pair.w()));
    }

    @Override
    public CoherenceWindow window() {
        return evaluator.window();
    }

    @Override
    public Power powers(DirectionPair pair, double wavelength) {
        return evaluator.powers(pair, wavelength);
    }

    @Override
    public double power(DirectionPair pair, double wavelength) {
        return ensemble ? powers(pair, wavelength).ensemble() : evaluator.coherent(pair, wavelength);
    }

    @Override
    public double[] xyz(DirectionPair pair, Quadrature quadrature) {
        // On the flanks of orders in monochromatic light, a millionth of their maximum is a large relative error.
        return quadrature == Quadrature.EXACT || !cie.isSmooth()
                ? WavelengthNodes.exact(cie, wavelength -> power(pair, wavelength), step(pair))
                : WavelengthNodes.integrated(cie, step(pair)).sum(wavelength -> power(pair, wavelength));
    }

    @Override
    public double products(DirectionPair pair) {
        return WavelengthNodes.integrated(cie, step(pair)).count() * evaluator.productCount(ensemble);
    }
}
