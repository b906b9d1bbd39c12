package sunbeam.app.scene.mesh.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import sunbeam.app.files.input.InputException;

/**
 * A format of mesh files, known by how a file begins.
 *
 * @param endings of the names of such files, for choosers
 * @param start how a file of the format begins, as far as {@link #HEAD} goes
 * @param reader reads the geometry
 */
public record MeshFormat(List<String> endings, Start start, Reader reader) {
    private static final int HEAD = 64;

    /** All formats; what begins like no other is OBJ, which has no mark. */
    private static final List<MeshFormat> ALL = List.of(
            new MeshFormat(List.of("ply"), head -> head.startsWith("ply\n") || head.startsWith("ply\r"), PlyFile::read),
            new MeshFormat(
                    List.of("glb", "gltf"),
                    head -> head.startsWith(GlbFile.MAGIC) || head.strip().startsWith("{"),
                    GltfFile::read),
            new MeshFormat(List.of("obj"), head -> true, ObjFile::read));

    /** Says whether a file begins as the format has it, each byte being a character. */
    interface Start {
        boolean fits(String head);
    }

    /** Reads a file or throws an {@link InputException} that says what is wrong with it. */
    interface Reader {
        RawMesh read(Path file);
    }

    /** The format of a file. */
    public static MeshFormat of(Path file) {
        InputException.requireRegular(file);
        try (InputStream stream = Files.newInputStream(file)) {
            MeshLimits.requireSize(file);
            String head = new String(stream.readNBytes(HEAD), StandardCharsets.ISO_8859_1);
            return ALL.stream()
                    .filter(format -> format.start.fits(head))
                    .findFirst()
                    .orElseThrow();
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    public RawMesh read(Path file) {
        return reader.read(file);
    }

    /** Whether a file is named as meshes are. */
    public static boolean isNamed(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return ALL.stream().flatMap(format -> format.endings.stream()).anyMatch(ending -> name.endsWith("." + ending));
    }
}
