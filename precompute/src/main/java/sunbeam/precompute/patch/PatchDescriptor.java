package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.json.JsonFile;
import sunbeam.precompute.json.JsonObject;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Quoted;

/**
 * JSON file that describes a patch beside the file of its heights:
 *
 * <pre>{@code
 * {
 *   "heights":   "elaphe.png",   file in the descriptor's folder or below it; required
 *   "width":     "65 um",        extent along x; required if the file does not state it
 *   "maxHeight": "375 nm",       height of full scale: 255 of 8 bits, 65535 of 16 bits, 1.0 of floats
 *   "note":      "shed skin"     remark, which the program ignores
 * }
 * }</pre>
 *
 * <p>and other settings of {@link PatchSettings#OF_FILES}. Descriptors are untrusted, so they may name no file outside their folder.
 *
 * @param file the descriptor itself
 * @param heights file of the heights, inside the descriptor's folder
 */
record PatchDescriptor(Path file, Path heights, Choices choices) {
    /**
     * @throws PatchException if the descriptor cannot be read or its heights are missing
     * @throws sunbeam.precompute.json.JsonException if the descriptor is malformed
     * @throws sunbeam.precompute.setting.SettingException if one of its values cannot be used
     */
    static PatchDescriptor read(Path file) {
        MeasuredHeights.requireReadable(file);
        JsonObject keys = json(file);
        String heights = keys.text("heights", keys.required("heights", "\"scan.png\""));
        Path inside = inside(file, keys.name("heights"), heights);
        Choices choices = keys.choices(PatchSettings.OF_FILES);
        keys.find("note").ifPresent(value -> keys.text("note", value));
        keys.requireNoOthers();
        return new PatchDescriptor(file, inside, choices);
    }

    private static JsonObject json(Path file) {
        try {
            return JsonFile.read(file);
        } catch (IOException failure) {
            throw new PatchException(file + " cannot be read (" + failure.getMessage() + "); check the file", failure);
        }
    }

    /** The file must lie in the descriptor's folder or below after all links are followed. */
    private static Path inside(Path descriptor, String name, String heights) {
        if (heights.isBlank()) {
            throw new PatchException(name + " is empty; name a file in the descriptor's own folder");
        }
        try {
            OwnFolder folder = new OwnFolder(descriptor, "descriptor");
            Path file = folder.file(heights);
            if (!Files.exists(file)) {
                throw new PatchException(
                        name + " is " + Quoted.of(heights) + ", but there is no file " + file + "; check the name");
            }
            folder.requireNoWayOut(file);
            return file;
        } catch (IllegalArgumentException wrong) {
            throw new PatchException(name + " " + Quoted.of(heights) + " " + wrong.getMessage(), wrong);
        }
    }
}
