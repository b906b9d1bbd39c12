package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
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
        keys.required(PatchSettings.WIDTH.fileKey(), "\"65 um\"");
        keys.required(PatchSettings.MAX_HEIGHT.fileKey(), "\"375 nm\"");
        Choices choices = keys.choices(PatchSettings.OF_FILES);
        Path image = imageInside(file, keys.name("heights"), keys.text("heights", heights));
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
        Path relative = relativePath(name, heights);
        boolean leaves = relative.isAbsolute() || relative.getRoot() != null;
        for (Path part : relative) {
            leaves |= part.toString().equals("..");
        }
        if (leaves || heights.isBlank()) {
            throw new PatchException("%s is %s; name an image in the descriptor's own folder, without .. or leading /"
                    .formatted(name, Quoted.of(heights)));
        }
        Path image = descriptor.resolveSibling(relative);
        if (!Files.exists(image)) {
            throw new PatchException(
                    "%s is %s, but there is no file %s; check the name".formatted(name, Quoted.of(heights), image));
        }
        try {
            Path folder = descriptor.toAbsolutePath().getParent().toRealPath();
            if (!image.toRealPath().startsWith(folder)) {
                throw new PatchException(
                        "%s is %s, a link that leads out of the descriptor's folder; copy the image there"
                                .formatted(name, Quoted.of(heights)));
            }
        } catch (IOException e) {
            throw new PatchException(
                    "%s is %s, which cannot be followed (%s); check the file"
                            .formatted(name, Quoted.of(heights), e.getMessage()),
                    e);
        }
        return image;
    }

    private static Path relativePath(String name, String heights) {
        try {
            return Path.of(heights);
        } catch (InvalidPathException e) {
            throw new PatchException(
                    "%s is %s, which is no file name (%s); mend it".formatted(name, Quoted.of(heights), e.getReason()),
                    e);
        }
    }
}
