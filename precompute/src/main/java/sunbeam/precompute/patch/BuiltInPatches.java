package sunbeam.precompute.patch;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/** The patches that need no file, by name. */
public interface BuiltInPatches {
    /** All names, in the order in which they are shown to users. */
    List<String> names();

    /** The heights of the patch of that name in metres; empty when there is none. */
    Optional<HeightMap> find(String name);

    /** Patches that are generated when they are asked for; names come in the map's order. */
    static BuiltInPatches of(Map<String, Supplier<HeightMap>> generators) {
        Map<String, Supplier<HeightMap>> copy = new LinkedHashMap<>(generators);
        return new BuiltInPatches() {
            @Override
            public List<String> names() {
                return List.copyOf(copy.keySet());
            }

            @Override
            public Optional<HeightMap> find(String name) {
                return Optional.ofNullable(copy.get(name)).map(Supplier::get);
            }
        };
    }

    /** No patches at all. */
    static BuiltInPatches none() {
        return of(Map.of());
    }
}
