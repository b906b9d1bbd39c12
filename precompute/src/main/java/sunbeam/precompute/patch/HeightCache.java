package sunbeam.precompute.patch;

import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Cache of the heights of built-in patches, whose generation takes half a second. */
public interface HeightCache {
    /** Cache that stores nothing: every call generates the heights. */
    HeightCache NONE = (name, generated) -> generated.get();

    /** Returns the heights of a built-in patch from the cache, or generates them. */
    HeightMap get(String name, Supplier<HeightMap> generated);
}
