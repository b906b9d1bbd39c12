package sunbeam.precompute.patch.builtin;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.PatchException;

/**
 * The patches that Sunbeam generates itself, by name. All are periodic, so they tile without a seam, and the same on
 * every run. Parameters and their sources: docs/guide.md.
 */
public final class BuiltInPatches {
    private static final Map<String, Supplier<HeightMap>> GENERATORS = new LinkedHashMap<>();

    static {
        GENERATORS.put("blaze", () -> BlazedGrating.standard().generate());
        GENERATORS.put("sinusoid", () -> SinusoidalGrating.standard().generate());
        GENERATORS.put("lamellar", () -> LamellarGrating.standard().generate());
        GENERATORS.put("disc", () -> CompactDisc.standard().generate());
        GENERATORS.put("elaphe-like", () -> SnakeSkins.elapheLike().generate());
        GENERATORS.put("xenopeltis-like", () -> SnakeSkins.xenopeltisLike().generate());
    }

    private BuiltInPatches() {}

    /** The names, simple gratings first. */
    public static List<String> names() {
        return List.copyOf(GENERATORS.keySet());
    }

    /**
     * Generates a patch, heights in metres, not levelled.
     *
     * @throws PatchException when there is no such patch; its message lists those that there are
     */
    public static HeightMap generate(String name) {
        Supplier<HeightMap> generator = GENERATORS.get(name);
        if (generator == null) {
            throw new PatchException(
                    "no built-in patch is called '" + name + "'; there are " + String.join(", ", names()));
        }
        return generator.get();
    }
}
