package sunbeam.app.scene;

import java.util.Optional;
import sunbeam.app.json.JsonObject;
import sunbeam.app.json.JsonValue;
import sunbeam.precompute.patch.Channel;
import sunbeam.precompute.patch.Levelling;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.units.Lengths;

/** The key {@code patch} of a scene: a name alone, or an object with a file and its scale. */
final class ScenePatchReader {
    private static final double SMALLEST = 1e-12;
    private static final double LARGEST = 1;

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
                length(patch, "width"),
                length(patch, "height"),
                length(patch, "maxHeight"),
                patch.parsed("channel", Channel::parse),
                patch.parsed("levelling", Levelling::parse));
        patch.requireNoOthers();
        return request;
    }

    private String source(String name) {
        return folder.resolve(name, BuiltInPatches.names());
    }

    private static Optional<Double> length(JsonObject patch, String key) {
        return patch.parsed(key, text -> {
            double metres = Lengths.parse(text);
            if (!(metres >= SMALLEST && metres <= LARGEST)) {
                throw new IllegalArgumentException(Lengths.format(metres) + " is out of range; give "
                        + Lengths.format(SMALLEST) + " to " + Lengths.format(LARGEST));
            }
            return metres;
        });
    }
}
