package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.DirectionPair;

/** X, Y, Z of the power of replicated patches: a trapezoid over 380..780 nm fine enough for all of their extent. */
public final class ReplicaColor {
    private static final double COARSEST_STEP = 0.5e-9;
    // The power of an aperture of width a is band-limited in frequency: |u| a + |v| b cycles per unit of 1 / lambda.
    // The
    // trapezoid rule needs more than one node a cycle; the margin is for the colour matching functions.
    private static final double NODES_PER_CYCLE = 3;

    private final ReplicaEvaluator evaluator;
    private final CieTable cie;

    public ReplicaColor(ReplicaEvaluator evaluator, CieTable cie) {
        this.evaluator = evaluator;
        this.cie = cie;
    }

    /** X, Y, Z of the power, without any gain. */
    public double[] xyz(DirectionPair pair) {
        double cycles = Math.abs(pair.u()) * evaluator.width() + Math.abs(pair.v()) * evaluator.height();
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        double step = Math.min(COARSEST_STEP, shortest * shortest / (NODES_PER_CYCLE * Math.max(1e-9, cycles)));
        WavelengthNodes nodes = WavelengthNodes.uniform(cie, step);
        double[] sum = new double[3];
        for (int i = 0; i < nodes.count(); i++) {
            double power = evaluator.power(pair, nodes.wavelengths()[i]);
            for (int c = 0; c < 3; c++) {
                sum[c] += power * nodes.weights()[i][c];
            }
        }
        return sum;
    }
}
