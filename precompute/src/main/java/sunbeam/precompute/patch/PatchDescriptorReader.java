package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
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
