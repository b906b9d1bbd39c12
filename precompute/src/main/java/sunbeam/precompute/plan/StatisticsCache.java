package sunbeam.precompute.plan;

import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Keeps numbers that are found in heights, alike each time, and take long to find. */
@FunctionalInterface
public interface StatisticsCache {
    /** Finds all anew. */
    StatisticsCache NONE = (map, name, found) -> found.get();

    /**
     * Numbers as they were kept, or found.
     *
     * @param name all that determines them but the heights and the program
     */
    double[] get(HeightMap map, String name, Supplier<double[]> found);
}
