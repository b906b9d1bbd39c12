package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ExactIntegral;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/**
 * Exact light of replicas with sharp edges.
 *
 * @param window Gaussian window with the area of all replicas
 */
public record ReplicaLight(ReplicaEvaluator evaluator, CoherenceWindow window, CieTable cie) implements ExactLight {
    // With all replicas a long and b wide, the power has at most |u| a + |v| b cycles per unit of 1 / lambda.
    private static final double NODES_PER_CYCLE = 3;
    // Cycles per meter, as in ReferenceColor.
    private static final double WIDEST_STEP = 12e3;

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

    /** Nine digits with either quadrature, since that is fast enough. */
    @Override
    public double[] xyz(DirectionPair pair, Quadrature quadrature) {
        return ExactIntegral.xyz(cie, wavelength -> evaluator.power(pair, wavelength), step(pair));
    }

    @Override
    public double products(DirectionPair pair) {
        return CieTable.BAND_WIDTH / step(pair) * evaluator.samples();
    }

    private double step(DirectionPair pair) {
        double cycles = Math.abs(pair.u()) * evaluator.width() + Math.abs(pair.v()) * evaluator.height();
        return 1 / (NODES_PER_CYCLE * cycles + 1 / WIDEST_STEP);
    }
}
