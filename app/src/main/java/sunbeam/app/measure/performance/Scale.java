package sunbeam.app.measure.performance;

import java.util.List;
import sunbeam.precompute.plan.GaussianArea;

/**
 * How much is measured.
 *
 * @param area window and average of the methods that have them
 * @param tolerances that {@code table} is baked for on each patch
 * @param mapSize width and height of the maps that are timed, pixels
 * @param frames that are timed of each
 * @param views at which errors are measured
 * @param growthTolerance that methods keep where cost grows
 * @param sizes widths of maps, pixels
 * @param samples along a side of the patch
 * @param reliefs metres
 * @param lengths coherence lengths, metres
 * @param budgetSeconds what is expected to take longer is not measured but estimated
 */
record Scale(
        GaussianArea area,
        List<Double> tolerances,
        int mapSize,
        int frames,
        int views,
        double growthTolerance,
        List<Integer> sizes,
        List<Integer> samples,
        List<Double> reliefs,
        List<Double> lengths,
        double budgetSeconds) {
    /** Some ten minutes on two processors. */
    static final Scale USUAL = new Scale(
            GaussianArea.STANDARD,
            List.of(3e-2, 1e-2, 3e-3, 1e-3),
            256,
            2,
            40,
            1e-2,
            List.of(128, 256, 512, 1024, 2048),
            List.of(256, 512, 1024, 2048),
            List.of(0.1e-6, 0.3e-6, 1e-6, 2.5e-6, 5e-6),
            List.of(8e-6, 16e-6, 32e-6, 65e-6, 130e-6, 260e-6),
            30);

    /** Some three minutes. */
    static final Scale QUICK = new Scale(
            GaussianArea.STANDARD,
            List.of(3e-2, 1e-2),
            128,
            1,
            12,
            3e-2,
            List.of(128, 512, 1024),
            List.of(256, 1024),
            List.of(0.1e-6, 1e-6, 5e-6),
            List.of(8e-6, 32e-6, 130e-6),
            10);

    Scale {
        tolerances = List.copyOf(tolerances);
        sizes = List.copyOf(sizes);
        samples = List.copyOf(samples);
        reliefs = List.copyOf(reliefs);
        lengths = List.copyOf(lengths);
    }
}
