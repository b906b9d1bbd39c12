package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/**
 * Exact diffracted power under a Gaussian coherence window; {@code window} is the one that {@code evaluator} was made with.
 *
 * @param ensemble whether powers are means over all positions of the window
 */
public record WindowLight(ReferenceEvaluator evaluator, CoherenceWindow window, CieTable cie, boolean ensemble)
        implements ExactLight {
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
        return new ReferenceColor(evaluator, window, cie, quadrature).xyz(pair, ensemble);
    }

    @Override
    public double products(DirectionPair pair) {
        int wavelengths = new ReferenceColor(evaluator, window, cie).nodes(pair).wavelengths().length;
        return wavelengths * evaluator.productCount(ensemble);
    }
}
