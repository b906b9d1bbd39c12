package sunbeam.precompute.plan;

/** The part of a surface from which light adds up by amplitude. */
public sealed interface CoherenceArea permits GaussianArea, ReplicatedArea {}
