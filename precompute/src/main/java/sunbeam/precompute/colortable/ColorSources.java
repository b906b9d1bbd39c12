package sunbeam.precompute.colortable;

import java.util.function.LongConsumer;
import sunbeam.precompute.shader.ShaderTables;

/** Who evaluates a method's shader. */
@FunctionalInterface
public interface ColorSources {

    /**
     * A source of a method's colors, to be closed by the caller.
     *
     * @param tables what the method's shader reads
     * @param done told how many more places are done
     */
    ColorSource of(ShaderTables tables, LongConsumer done);
}
