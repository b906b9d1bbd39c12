package sunbeam.precompute.reference;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ExactIntegral;
import sunbeam.precompute.optics.DirectionPair;

/** X, Y, Z of the power of replicated patches, to nine digits. */
public record ReplicaColor(ReplicaEvaluator evaluator, CieTable cie) {
    // The power of an aperture of width a is band-limited in frequency: |u| a + |v| b cycles per unit of 1 / lambda.
    private static final double NODES_PER_CYCLE = 3;
    // What the color matching functions need, cycles per metre: as ReferenceColor's.
    private static final double WIDEST_STEP = 12e3;


    /** X, Y, Z of the power, without any gain. */
    public double[] xyz(DirectionPair pair) {
        double cycles = Math.abs(pair.u()) * evaluator.width() + Math.abs(pair.v()) * evaluator.height();
        double step = 1 / (NODES_PER_CYCLE * cycles + 1 / WIDEST_STEP);
        return ExactIntegral.xyz(cie, wavelength -> evaluator.power(pair, wavelength), step);
    }
}
