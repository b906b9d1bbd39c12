package sunbeam.app.scene.mesh.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Predicate;
import sunbeam.app.files.input.InputException;

/**
 * A format of mesh files, recognized by a file's first bytes.
 *
 * @param endings file name endings, without the dot
 * @param start test of a file's first {@link #HEAD_BYTES} bytes, as Latin-1 characters
 * @param reader reader of the geometry; throws an {@link InputException} for a damaged file
 */
public record MeshFormat(List<String> endings, Predicate<String> start, Function<Path, RawMesh> reader) {
    private static final int HEAD_BYTES = 64;

    /** All formats; a file that matches no other is OBJ, which has no signature. */
    private static final List<MeshFormat> ALL = List.of(
            new MeshFormat(List.of("ply"), head -> head.startsWith("ply\n") || head.startsWith("ply\r"), PlyFile::read),
            new MeshFormat(
                    List.of("glb", "gltf"),
                    head -> head.startsWith(GlbFile.MAGIC) || head.strip().startsWith("{"),
                    GltfFile::read),
            new MeshFormat(List.of("obj"), head -> true, ObjFile::read));

    public static MeshFormat of(Path file) {
        InputException.requireRegular(file);
        try (InputStream stream = Files.newInputStream(file)) {
            MeshLimits.requireSize(file);
            String head = new String(stream.readNBytes(HEAD_BYTES), StandardCharsets.ISO_8859_1);
            return ALL.stream()
                    .filter(format -> format.start.test(head))
                    .findFirst()
                    .orElseThrow();
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    public RawMesh read(Path file) {
        return reader.apply(file);
    }

    public static boolean isNamed(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return ALL.stream().flatMap(format -> format.endings.stream()).anyMatch(ending -> name.endsWith("." + ending));
    }
}
