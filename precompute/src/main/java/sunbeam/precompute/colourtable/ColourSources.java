package sunbeam.precompute.colourtable;

import sunbeam.precompute.shader.ShaderTables;

/** Who evaluates a method's shader. */
@FunctionalInterface
public interface ColourSources {

    /**
     * A source of a method's colours, to be closed by the caller.
     *
     * @param tables what the method's shader reads
     * @param places that will be asked for in all, for those who show progress
     */
    ColourSource of(ShaderTables tables, long places);
}
