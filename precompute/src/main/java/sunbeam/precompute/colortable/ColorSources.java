package sunbeam.precompute.colortable;

import sunbeam.precompute.shader.ShaderTables;

/** Who evaluates a method's shader. */
@FunctionalInterface
public interface ColorSources {

    /**
     * A source of a method's colors, to be closed by the caller.
     *
     * @param tables what the method's shader reads
     * @param places that will be asked for in all, for those who show progress
     */
    ColorSource of(ShaderTables tables, long places);
}
