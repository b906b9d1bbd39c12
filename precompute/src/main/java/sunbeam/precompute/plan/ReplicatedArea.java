package sunbeam.precompute.plan;

import sunbeam.precompute.optics.Replicas;

/**
 * A coherence area with sharp edges: a patch, side by side so many times, evenly lit.
 *
 * @param replicas along both axes
 */
public record ReplicatedArea(Replicas replicas) implements CoherenceArea {}
