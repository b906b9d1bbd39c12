package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Geometry;
import sunbeam.precompute.patch.HeightLevels;

/**
 * X, Y, Z of the reference's power. The power is evaluated at equal steps of 1 / lambda, close enough for a polynomial
 * between them, and integrated exactly against the colour matching functions ({@link IntegratedNodes}).
 */
public final class ReferenceColor {
    // The power of an order is a Gaussian of 1 / lambda. Sampled every 0.7 deviations, all that a polynomial through
    // the
    // samples misses oscillates from one step to the next and is lost in the integral (2 exp(-2 (pi / 0.7)^2)), save in
    // an order that the end of the band cuts: 1e-4 of that order.
    private static final double STEP_PER_DEVIATION = 0.7;
    // Steps per period of the interference between top and bottom of the relief.
    private static final double STEPS_PER_FRINGE = 8;
    // Near the specular direction nothing else limits the step: 5 nm in the blue.
    private static final double FEWEST_STEPS = 40;

    private final ReferenceEvaluator evaluator;
    private final CoherenceWindow window;
    private final CieTable cie;

    public ReferenceColor(ReferenceEvaluator evaluator, CoherenceWindow window, CieTable cie) {
        this.evaluator = evaluator;
        this.window = window;
        this.cie = cie;
    }

    /** The wavelengths that a direction needs: an order is sigma_f / (sqrt 2 |(u, v)|) wide in 1 / lambda. */
    public WavelengthNodes nodes(Geometry geometry) {
        double perMetre = FEWEST_STEPS / (1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH);
        double orders = Math.sqrt(2) * Math.hypot(geometry.u(), geometry.v()) / window.sigmaFrequency();
        HeightLevels heights = evaluator.heights();
        double fringes = Math.abs(geometry.w()) * (heights.maximum() - heights.minimum());
        double stepsPerUnit = Math.max(perMetre, orders / STEP_PER_DEVIATION + STEPS_PER_FRINGE * fringes);
        return IntegratedNodes.of(cie, 1 / stepsPerUnit);
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
