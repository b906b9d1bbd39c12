package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Geometry;

/** X, Y, Z of the reference's power: a trapezoid over 380..780 nm fine enough for the sharpest order. */
public final class ReferenceColor {
    private static final double COARSEST_STEP = 0.5e-9;
    // The trapezoid rule's relative error for a Gaussian of deviation s is 2 exp(-2 (pi s / step)^2): 5e-9 at this
    // ratio.
    private static final double STEP_PER_DEVIATION = 1.0;

    private final ReferenceEvaluator evaluator;
    private final CoherenceWindow window;
    private final CieTable cie;

    public ReferenceColor(ReferenceEvaluator evaluator, CoherenceWindow window, CieTable cie) {
        this.evaluator = evaluator;
        this.window = window;
        this.cie = cie;
    }

    /** The wavelengths that a direction needs: an order is lambda^2 sigma_f / (sqrt 2 |(u, v)|) wide. */
    public WavelengthNodes nodes(Geometry geometry) {
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        double deviation = shortest
                * shortest
                * window.sigmaFrequency()
                / (Math.sqrt(2) * Math.max(1e-9, Math.hypot(geometry.u(), geometry.v())));
        return WavelengthNodes.uniform(cie, Math.min(COARSEST_STEP, STEP_PER_DEVIATION * deviation));
    }

    /**
     * X, Y, Z of the power, without any gain.
     *
     * @param ensemble whether the mean over all positions of the window is meant
     */
    public double[] xyz(Geometry geometry, boolean ensemble) {
        WavelengthNodes nodes = nodes(geometry);
        double[] sum = new double[3];
        for (int i = 0; i < nodes.count(); i++) {
            double wavelength = nodes.wavelengths()[i];
            double power = ensemble
                    ? evaluator.powers(geometry, wavelength).ensemble()
                    : evaluator.coherent(geometry, wavelength);
            for (int c = 0; c < 3; c++) {
                sum[c] += power * nodes.weights()[i][c];
            }
        }
        return sum;
    }
}
