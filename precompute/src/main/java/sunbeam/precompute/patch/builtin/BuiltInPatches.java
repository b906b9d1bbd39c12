package sunbeam.precompute.patch.builtin;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;

/** Generators of the built-in patches, by name. All are periodic, and equal on every run. Parameters and their sources: docs/guide.md. */
public final class BuiltInPatches {
    /** Meters, as in the thesis. */
    private static final double PERIOD = 2.5e-6;
    /** The visible orders (up to 13 for 2.5 um and 380 nm) have no aliases. */
    private static final int COLUMNS = 128;
    /** Rows are equal and 78 nm apart, finer than a quarter of 380 nm. */
    private static final int ROWS = 32;

    private static final Map<String, Supplier<HeightMap>> GENERATORS = new LinkedHashMap<>();

    static {
        // Rises towards +x, so that light goes towards -x: order m has the power sinc^2(k w H / (2 pi) - m), w = -2
        // near the normal.
        GENERATORS.put("blaze", () -> grating(x -> 250e-9 * x));
        // Order m has the power J_m(k w amplitude)^2.
        GENERATORS.put("sinusoid", () -> grating(x -> 100e-9 * StrictMath.sin(2 * StrictMath.PI * x)));
        // Ridges of half the period have no even orders but 0; their height of lambda / 4 at 550 nm darkens the mirror
        // direction.
        GENERATORS.put("lamellar", () -> grating(x -> x < 0.5 ? 137.5e-9 : 0));
        GENERATORS.put("disc", CompactDisc::generate);
        GENERATORS.put("bumps", RandomBumps::generate);
        GENERATORS.put("elaphe-like", () -> FingerSkin.ELAPHE.generate());
        GENERATORS.put("xenopeltis-like", () -> FingerSkin.XENOPELTIS.generate());
    }

    private BuiltInPatches() {}

    /** Returns the names, simple gratings first. */
    public static List<String> names() {
        return List.copyOf(GENERATORS.keySet());
    }

    /** Generates a patch of this name; heights in meters, not leveled. */
    public static HeightMap generate(String name) {
        Supplier<HeightMap> generator = GENERATORS.get(name);
        if (generator == null) {
            throw new IllegalArgumentException("no built-in patch is called " + name);
        }
        return generator.get();
    }

    /** Samples the profile, over x in 0..1, at the middle of each interval. */
    private static HeightMap grating(DoubleUnaryOperator profile) {
        double[] heights = new double[ROWS * COLUMNS];
        Arrays.setAll(heights, i -> profile.applyAsDouble((i % COLUMNS + 0.5) / COLUMNS));
        return new HeightMap(COLUMNS, ROWS, PERIOD / COLUMNS, PERIOD / ROWS, heights);
    }
}
