package sunbeam.precompute.patch.builtin;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.PatchException;

/**
 * The patches that Sunbeam generates itself, by name. All are periodic, so they tile without a seam, and the same on
 * every run. Parameters and their sources: docs/patches.md.
 */
public final class BuiltInPatches {
    private record Entry(String name, String description, Supplier<HeightMap> generator) {}

    private static final List<Entry> ENTRIES = List.of(
            new Entry(
                    "blaze",
                    "blazed grating: a sawtooth rising towards +x, period 2.5 um, depth 250 nm",
                    () -> BlazedGrating.standard().generate()),
            new Entry(
                    "sinusoid",
                    "sinusoidal grating along x, period 2.5 um, amplitude 100 nm (relief 200 nm)",
                    () -> SinusoidalGrating.standard().generate()),
            new Entry(
                    "lamellar",
                    "rectangular grating along x, period 2.5 um, ridges 1.25 um wide and 137.5 nm high",
                    () -> LamellarGrating.standard().generate()),
            new Entry(
                    "disc",
                    "compact disc: tracks along y 1.6 um apart, pits 0.83 to 3.1 um long and 110 nm deep; 51.2 um wide",
                    () -> CompactDisc.standard().generate()),
            new Entry(
                    "elaphe-like",
                    "like shed skin of Elaphe guttata: pointed fingers 1.03 um apart in rows of 3.1 um; 65 um wide",
                    () -> SnakeSkins.elapheLike().generate()),
            new Entry(
                    "xenopeltis-like",
                    "like shed skin of Xenopeltis unicolor: blunt fingers 0.55 um apart in rows of 1.55 um; 65 um wide",
                    () -> SnakeSkins.xenopeltisLike().generate()));

    private BuiltInPatches() {}

    /** The names, simple gratings first. */
    public static List<String> names() {
        return ENTRIES.stream().map(Entry::name).toList();
    }

    /** Whether there is a built-in patch of this name. */
    public static boolean contains(String name) {
        return names().contains(name);
    }

    /**
     * One line that says what the patch is.
     *
     * @throws PatchException when there is no such patch; its message lists those that there are
     */
    public static String description(String name) {
        return find(name).description();
    }

    /**
     * Generates a patch, heights in metres, not levelled.
     *
     * @throws PatchException when there is no such patch; its message lists those that there are
     */
    public static HeightMap generate(String name) {
        return find(name).generator().get();
    }

    private static Entry find(String name) {
        return ENTRIES.stream()
                .filter(entry -> entry.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new PatchException("no built-in patch is called '" + name + "'; there are "
                        + names().stream().collect(Collectors.joining(", "))));
    }
}
