package sunbeam.precompute.plan;

/** Which power is meant. */
public enum Average {
    /** One coherence area: amplitudes first, square last (thesis algorithm 3.3). */
    COHERENT,
    /** The mean over all positions of the window: Stam's angle brackets, what a pixel of a mesh sees. */
    ENSEMBLE
}
