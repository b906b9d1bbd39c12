package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.reference.ExactLight;

/** The part of a surface from which light adds up by amplitude. */
public sealed interface CoherenceArea permits GaussianArea, ReplicatedArea {
    /** What a surface diffracts from such areas, by direct sums. */
    ExactLight over(HeightMap map, CieTable cie);
}
