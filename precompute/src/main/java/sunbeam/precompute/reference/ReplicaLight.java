package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/**
 * Light of replicas with sharp edges, which lie at one place.
 *
 * @param window of the area of all replicas
 */
public record ReplicaLight(ReplicaEvaluator evaluator, CoherenceWindow window, CieTable cie) implements ExactLight {
    @Override
    public Power powers(DirectionPair pair, double wavelength) {
        double power = power(pair, wavelength);
        return new Power(power, power);
    }

    @Override
    public boolean ensemble() {
        return false;
    }

    @Override
    public double power(DirectionPair pair, double wavelength) {
        return evaluator.power(pair, wavelength);
    }

    /** To nine digits, however asked for: one way is fast enough. */
    @Override
    public double[] xyz(DirectionPair pair, Quadrature quadrature) {
        return new ReplicaColor(evaluator, cie).xyz(pair);
    }
}
