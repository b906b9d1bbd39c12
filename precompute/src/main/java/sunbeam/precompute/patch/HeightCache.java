package sunbeam.precompute.patch;

import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Keeps heights that the program generates alike each time, which takes half a second. */
public interface HeightCache {
    /** Generates all anew. */
    HeightCache NONE = (name, generated) -> generated.get();

    /** Heights of a built-in patch as they were kept, or generated. */
    HeightMap get(String name, Supplier<HeightMap> generated);
}
