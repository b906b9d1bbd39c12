package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.json.JsonFile;
import sunbeam.precompute.json.JsonObject;
import sunbeam.precompute.json.JsonValue;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Quoted;

/** Reads {@link PatchDescriptor}s. A descriptor may come from anywhere, so it reaches no file outside its folder. */
final class PatchDescriptorReader {
    private PatchDescriptorReader() {}

    /**
     * Reads a descriptor.
     *
     * @throws PatchException when the descriptor cannot be read or its image is not there
     * @throws sunbeam.precompute.json.JsonException when it is not such a file; names file, line and key
     * @throws sunbeam.precompute.setting.SettingException when one of its values cannot be used; names these, too
     */
    static PatchDescriptor read(Path file) {
        InputFiles.requireReadable(file);
        JsonObject keys = json(file);
        JsonValue heights = keys.required("heights", "\"scan.png\"");
        Path image = imageInside(file, keys.name("heights"), keys.text("heights", heights));
        if (!HeightFiles.isScan(image)) {
            keys.required(PatchSettings.WIDTH.fileKey(), "\"65 um\"");
            if (keys.find(PatchSettings.HEIGHT_UNIT.fileKey()).isEmpty()) {
                keys.required(PatchSettings.MAX_HEIGHT.fileKey(), "\"375 nm\"");
            }
        }
        Choices choices = keys.choices(PatchSettings.OF_FILES);
        String note = keys.find("note").map(value -> keys.text("note", value)).orElse("");
        keys.requireNoOthers();
        return new PatchDescriptor(file, image, choices, note);
    }

    private static JsonObject json(Path file) {
        try {
            return JsonFile.read(file);
        } catch (IOException failure) {
            throw new PatchException(file + " cannot be read (" + failure.getMessage() + "); check the file", failure);
        }
    }

    /** The image that the descriptor names, which after following all links must lie in the descriptor's folder. */
    private static Path imageInside(Path descriptor, String name, String heights) {
        if (heights.isBlank()) {
            throw new PatchException(name + " is empty; name an image in the descriptor's own folder");
        }
        try {
            OwnFolder folder = new OwnFolder(descriptor, "descriptor");
            Path image = folder.file(heights);
            if (!Files.exists(image)) {
                throw new PatchException(String.format(
                        Locale.ROOT,
                        "%s is %s, but there is no file %s; check the name",
                        name,
                        Quoted.of(heights),
                        image));
            }
            folder.requireNoWayOut(image);
            return image;
        } catch (IllegalArgumentException wrong) {
            throw new PatchException(name + " " + Quoted.of(heights) + " " + wrong.getMessage(), wrong);
        }
    }
}
