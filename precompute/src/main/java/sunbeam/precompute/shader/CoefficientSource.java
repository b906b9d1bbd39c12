package sunbeam.precompute.shader;

/** Where shaders/include/expansion.glsl has its coefficients from. */
public enum CoefficientSource {
    /** The closed form of Taylor's series. */
    TAYLOR,
    /** An array of samples. */
    SAMPLED;

    /**
     * Chooses this source for a method's shader.
     *
     * @param terms of the expansion
     */
    public void defineIn(ShaderTables.Builder tables, int terms) {
        for (int i = 0; i < values().length; i++) {
            tables.define(values()[i].constant(), i);
        }
        tables.define("EXPANSION", constant()).define("TERMS", terms);
    }

    private String constant() {
        return "EXPANSION_" + name();
    }
}
