package sunbeam.precompute.plan;

import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Cache of statistics of height maps that take long to compute. */
@FunctionalInterface
public interface StatisticsCache {
    StatisticsCache NONE = (map, name, computation) -> computation.get();

    /**
     * Returns cached or newly computed statistics.
     *
     * @param name text that determines the statistics, together with the heights and the program's version
     */
    double[] get(HeightMap map, String name, Supplier<double[]> computation);
}
