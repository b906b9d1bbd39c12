package sunbeam.precompute.plan;

/** Kind of average of the diffracted power over the patch. */
public enum Average {
    /** One coherence area: amplitudes are summed, then squared (thesis algorithm 3.3). */
    COHERENT,
    /** Mean of the power over all positions of the window, as a pixel of a mesh sees it: Stam's angle brackets. */
    ENSEMBLE;

    public void defineIn(ShaderTables.Builder tables) {
        for (int i = 0; i < values().length; i++) {
            tables.define("AVERAGE_" + values()[i], i);
        }
        tables.define("AVERAGE", "AVERAGE_" + this);
    }
}
