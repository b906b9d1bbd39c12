package sunbeam.precompute.patch;

import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Cache of the heights of built-in patches, whose generation takes half a second. */
public interface HeightCache {
    /** Generates the heights in every call. */
    HeightCache NONE = (name, generated) -> generated.get();

    /** Returns the heights from the cache, or generates them. */
    HeightMap get(String name, Supplier<HeightMap> generated);
}
