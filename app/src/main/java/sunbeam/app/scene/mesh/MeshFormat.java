package sunbeam.app.scene.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import sunbeam.precompute.files.InputException;

/** Format of mesh files, recognized by the first {@link #HEAD_BYTES} bytes as Latin-1. */
public record MeshFormat(List<String> endings, Predicate<String> start, Reader reader) {
    private static final int HEAD_BYTES = 64;
    private static final long MOST_BYTES = 1L << 29;

    /** A file that matches no other is OBJ, which has no signature. */
    private static final List<MeshFormat> ALL = List.of(
            new MeshFormat(List.of("ply"), head -> head.startsWith("ply\n") || head.startsWith("ply\r"), PlyFile::read),
            new MeshFormat(
                    List.of("glb", "gltf"),
                    head -> head.startsWith(GltfFile.MAGIC) || head.strip().startsWith("{"),
                    GltfFile::read),
            new MeshFormat(List.of("obj"), head -> true, ObjFile::read));

    /** Throws an {@link InputException} for damaged files; the message does not name the file. */
    @FunctionalInterface
    public interface Reader {
        RawMesh read(Path file) throws IOException;
    }

    /** @throws InputException if the file is missing, too large or damaged */
    public static RawMesh read(Path file) {
        InputException.requireRegular(file);
        return InputException.naming(file, () -> {
            requireSize(file);
            String head = head(file);
            return ALL.stream()
                    .filter(format -> format.start.test(head))
                    .findFirst()
                    .orElseThrow()
                    .reader
                    .read(file);
        });
    }

    private static String head(Path file) throws IOException {
        try (InputStream stream = Files.newInputStream(file)) {
            return new String(stream.readNBytes(HEAD_BYTES), StandardCharsets.ISO_8859_1);
        }
    }

    static void requireSize(Path file) throws IOException {
        long bytes = Files.size(file);
        if (bytes > MOST_BYTES) {
            throw new InputException(file.getFileName() + " has " + bytes + " bytes; at most " + MOST_BYTES
                    + " can be used, so simplify the mesh");
        }
    }

    public static boolean isNamed(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return ALL.stream().flatMap(format -> format.endings.stream()).anyMatch(ending -> name.endsWith("." + ending));
    }
}
