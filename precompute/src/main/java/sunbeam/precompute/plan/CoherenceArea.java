package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReplicaLight;

/** Part of a surface over which light adds by amplitude. */
public sealed interface CoherenceArea permits GaussianArea, CoherenceArea.Replicated {
    ExactLight over(HeightMap map, CieTable cie);

    /** Area with sharp edges: replicas of the patch side by side, evenly lit. */
    record Replicated(Replicas replicas) implements CoherenceArea {
        @Override
        public ExactLight over(HeightMap map, CieTable cie) {
            return new ReplicaLight(map, replicas, cie);
        }
    }
}
