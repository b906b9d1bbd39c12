package sunbeam.app.scene;

import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.app.json.JsonObject;
import sunbeam.app.json.JsonValue;
import sunbeam.precompute.patch.Channel;
import sunbeam.precompute.patch.Levelling;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;

/** The key {@code patch} of a scene: a name alone, or an object with a file and its scale. */
final class ScenePatchReader {
    /** Of float images that hold metres; how high the surface itself may be is judged with its samples. */
    private static final double LARGEST_FULL_SCALE = 1;

    private final JsonObject root;
    private final SceneFolder folder;

    ScenePatchReader(JsonObject root, SceneFolder folder) {
        this.root = root;
        this.folder = folder;
    }

    PatchRequest read() {
        JsonValue value = root.required("patch", "\"elaphe-like\"");
        if (value instanceof JsonValue.Text) {
            return PatchRequest.of(root.parsed("patch", value, this::source));
        }
        JsonObject patch = root.object("patch", "");
        PatchRequest request = new PatchRequest(
                patch.parsed("file", patch.required("file", "\"scan.png\""), this::source),
                side(patch, "width"),
                side(patch, "height"),
                length(patch, "maxHeight", PatchRequest.SMALLEST_MAX_HEIGHT, LARGEST_FULL_SCALE),
                patch.parsed("channel", Channel::parse),
                patch.parsed("levelling", Levelling::parse));
        patch.requireNoOthers();
        return request;
    }

    private String source(String name) {
        return folder.resolve(name, BuiltInPatches.names());
    }

    private static Optional<Double> length(JsonObject patch, String key, double least, double most) {
        OptionalDouble metres = SceneValues.length(patch, key, least, most);
        return metres.isPresent() ? Optional.of(metres.getAsDouble()) : Optional.empty();
    }

    private static Optional<Double> side(JsonObject patch, String key) {
        return length(patch, key, PatchRequest.SHORTEST_SIDE, PatchRequest.LONGEST_SIDE);
    }
}
