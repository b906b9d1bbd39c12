package sunbeam.precompute.patch;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.text.Quoted;

/** Reads {@link PatchDescriptor}s. A descriptor may come from anywhere, so it reaches no file outside its folder. */
final class PatchDescriptorReader {
    private static final List<String> KEYS =
            List.of("heights", "width", "height", "maxHeight", "channel", "levelling", "note");

    private PatchDescriptorReader() {}

    /** @throws PatchException when the descriptor cannot be read, in one line that names the file and the key */
    static PatchDescriptor read(Path file) {
        DescriptorKeys keys = DescriptorKeys.read(file);
        keys.requireOnly(KEYS);
        String heights = keys.required("heights", "scan.png");
        NamedLength width = length(keys, "width", keys.required("width", "65 um"));
        NamedLength maxHeight = length(keys, "maxHeight", keys.required("maxHeight", "375 nm"));
        Optional<NamedLength> extent = keys.optional("height").map(text -> length(keys, "height", text));
        return new PatchDescriptor(
                file,
                imageInside(file, keys.name("heights"), heights),
                new PatchScale(width, extent, maxHeight),
                keys.optional("channel", Channel::parse),
                keys.optional("levelling", Levelling::parse),
                keys.optional("note").orElse(""));
    }

    private static NamedLength length(DescriptorKeys keys, String key, String text) {
        return NamedLength.parse(keys.name(key), text);
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
                throw new PatchException(
                        "%s is %s, but there is no file %s; check the name".formatted(name, Quoted.of(heights), image));
            }
            folder.requireNoWayOut(heights, image);
            return image;
        } catch (IllegalArgumentException wrong) {
            throw new PatchException(name + ": " + wrong.getMessage(), wrong);
        }
    }
}
