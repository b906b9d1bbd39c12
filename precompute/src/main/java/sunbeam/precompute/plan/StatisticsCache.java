package sunbeam.precompute.plan;

import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Cache of statistics of height maps that take long to compute. */
@FunctionalInterface
public interface StatisticsCache {
    /** Computes everything anew. */
    StatisticsCache NONE = (map, name, found) -> found.get();

    /**
     * Returns cached or newly computed statistics.
     *
     * @param name everything that determines them except the heights and the program
     */
    double[] get(HeightMap map, String name, Supplier<double[]> found);
}
