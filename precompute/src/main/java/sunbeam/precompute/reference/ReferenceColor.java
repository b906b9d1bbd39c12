package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightLevels;

/** X, Y, Z of the reference's power over 380..780 nm. */
public final class ReferenceColor {
    private static final double COARSEST_STEP = 0.5e-9;
    // The trapezoid rule's relative error for a Gaussian of deviation s is 2 exp(-2 (pi s / step)^2): 5e-9 at this
    // ratio.
    private static final double STEP_PER_DEVIATION = 1.0;

    // Steps of 1 / lambda for polynomials of degree 11, set by comparison with steps of 0.5 pm for orders of all widths
    // anywhere in the band: 0.7 deviations of an order's power, and not above what the colour matching functions need
    // (cycles per metre; 2 nm in the blue, 7 nm in the red). Error 5e-9 median, 5e-7 at most.
    private static final double NODES_PER_DEVIATION = 1 / 0.7;
    private static final double WIDEST_STEP = 12e3;
    // Nodes per period of the interference between top and bottom of the relief.
    private static final double NODES_PER_FRINGE = 8;

    /** How power is integrated against the colour matching functions. */
    public enum Quadrature {
        /**
         * The trapezoid rule in steps of 0.5 nm, or finer where orders are narrower. Sampling tables that are linear
         * between whole nanometres errs by 6e-5 (median) to 6e-4 for narrow orders.
         */
        TRAPEZOID,
        /** Few powers, integrated exactly ({@link IntegratedNodes}): faster by two to three, right to 1e-6. */
        INTEGRATED
    }

    private final ReferenceEvaluator evaluator;
    private final CoherenceWindow window;
    private final CieTable cie;
    private final Quadrature quadrature;

    /** With the trapezoid rule. */
    public ReferenceColor(ReferenceEvaluator evaluator, CoherenceWindow window, CieTable cie) {
        this(evaluator, window, cie, Quadrature.TRAPEZOID);
    }

    public ReferenceColor(ReferenceEvaluator evaluator, CoherenceWindow window, CieTable cie, Quadrature quadrature) {
        this.evaluator = evaluator;
        this.window = window;
        this.cie = cie;
        this.quadrature = quadrature;
    }

    /** The wavelengths that a direction needs: an order is sigma_f / (sqrt 2 |(u, v)|) wide in 1 / lambda. */
    public WavelengthNodes nodes(DirectionPair pair) {
        double uv = Math.max(1e-9, Math.hypot(pair.u(), pair.v()));
        double deviation = window.sigmaFrequency() / (Math.sqrt(2) * uv);
        if (quadrature == Quadrature.TRAPEZOID) {
            double shortest = CieTable.MINIMUM_WAVELENGTH * CieTable.MINIMUM_WAVELENGTH * deviation;
            return WavelengthNodes.uniform(cie, Math.min(COARSEST_STEP, STEP_PER_DEVIATION * shortest));
        }
        HeightLevels heights = evaluator.heights();
        double fringes = Math.abs(pair.w()) * (heights.maximum() - heights.minimum());
        // What oscillates independently may beat: bandwidths add up.
        double nodesPerUnit = NODES_PER_DEVIATION / deviation + NODES_PER_FRINGE * fringes + 1 / WIDEST_STEP;
        return IntegratedNodes.of(cie, 1 / nodesPerUnit);
    }

    /**
     * X, Y, Z of the power, without any gain.
     *
     * @param ensemble whether the mean over all positions of the window is meant
     */
    public double[] xyz(DirectionPair pair, boolean ensemble) {
        WavelengthNodes nodes = nodes(pair);
        double[] sum = new double[3];
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            double power =
                    ensemble ? evaluator.powers(pair, wavelength).ensemble() : evaluator.coherent(pair, wavelength);
            for (int c = 0; c < 3; c++) {
                sum[c] += power * nodes.weights()[i][c];
            }
        }
        return sum;
    }
}
