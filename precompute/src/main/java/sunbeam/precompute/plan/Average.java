package sunbeam.precompute.plan;

import sunbeam.precompute.shader.ShaderTables;

/** Average of the power over the patch. */
public enum Average {
    /** One coherence area: amplitudes are summed, then squared (thesis algorithm 3.3). */
    COHERENT,
    /** Mean over all positions of the window: Stam's angle brackets, what a pixel of a mesh sees. */
    ENSEMBLE;

    /** Selects this average in a method's shader. */
    public void defineIn(ShaderTables.Builder tables) {
        for (int i = 0; i < values().length; i++) {
            tables.define(values()[i].constant(), i);
        }
        tables.define("AVERAGE", constant());
    }

    private String constant() {
        return "AVERAGE_" + name();
    }
}
