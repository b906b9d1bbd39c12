package sunbeam.precompute.plan;

import sunbeam.precompute.shader.ShaderTables;

/** Which power is meant. */
public enum Average {
    /** One coherence area: amplitudes first, square last (thesis algorithm 3.3). */
    COHERENT,
    /** The mean over all positions of the window: Stam's angle brackets, what a pixel of a mesh sees. */
    ENSEMBLE;

    /** Chooses this average for a method's shader. */
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
