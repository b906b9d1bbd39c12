package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.reference.ExactLight;

/** Part of a surface over which light adds by amplitude. */
public sealed interface CoherenceArea permits GaussianArea, ReplicatedArea {
    /** Returns the exact diffracted light of a patch, evaluated by direct sums. */
    ExactLight over(HeightMap map, CieTable cie);
}
