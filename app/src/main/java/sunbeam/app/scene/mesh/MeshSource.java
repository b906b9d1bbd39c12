package sunbeam.app.scene.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3d;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Mesh by name. A file with a built-in mesh's name needs its folder: {@code ./snake}. Files are OBJ, PLY and glTF: positions with z up,
 * faces of 3 to 1000 corners, without lines, points and materials; a glTF's first texture selects the texture coordinates. A mesh is
 * repaired, with a warning of what is changed:
 *
 * <ul>
 * <li>Triangles without area are dropped. A mesh far from the origin is moved there, because float32 would change its shape.
 * <li>Missing normals are means over the triangles around a position ({@link VertexAssembly}).
 * <li>Missing tangents follow the texture's u, or x (y where the surface faces along x) where it gives no direction; a mirrored texture
 *       gives a left-handed frame.
 * <li>If a face lacks texture coordinates, all are projected from above: x to u and y to v, the longer side from 0 to 1, right-handed.
 * </ul>
 *
 * @param unit unit of the file's numbers; meters for built-in meshes
 */
public record MeshSource(String name, Unit unit) {
    // Longest side in meters: pixels of a smaller mesh do not average many coherence areas of sunlight (65 um); a
    // larger one has more than a centimeter per pixel, most likely in a wrong unit.
    private static final double LEAST = 100e-6;
    private static final double MOST = 10;
    private static final Pattern ENDING = Pattern.compile("(?i)\\.(obj|ply|glb|gltf)$");
    private static final int HEAD_BYTES = 64;
    private static final long MOST_BYTES = 1L << 29;

    public enum Unit {
        M(1),
        CM(1e-2),
        MM(1e-3),
        UM(1e-6),
        IN(0.0254);

        final double meters;

        Unit(double meters) {
            this.meters = meters;
        }
    }

    /**
     * Mesh with a line for each kind of data that the reader dropped, moved or computed.
     *
     * @param parts meshes that together are the mesh; several if a file places one of its meshes several times
     */
    public record Loaded(Mesh mesh, List<Part> parts, List<String> warnings) {
        Loaded(Mesh mesh, List<String> warnings) {
            this(mesh, List.of(new Part(mesh, new Matrix4f())), warnings);
        }
    }

    /** A mesh at a place, to which an affine, invertible matrix leads; one mesh, as an object, may have several places. */
    public record Part(Mesh mesh, Matrix4fc place) {}

    public static MeshSource of(String name) {
        return new MeshSource(name, Unit.M);
    }

    /** True if the file has a mesh's ending. */
    public static boolean isFile(Path file) {
        return ENDING.matcher(file.toString()).find();
    }

    /** Throws InputException if there is no such mesh, or the file cannot be used. */
    public Loaded load() {
        if (BuiltInMeshes.names().contains(name)) {
            InputException.refuseIf(
                    unit != Unit.M, "mesh " + name + " is in meters; leave out the unit, which is for files");
            return new Loaded(BuiltInMeshes.create(name), List.of());
        }
        Path file = Path.of(name);
        if (!Files.exists(file) && !name.contains(".")) {
            throw new InputException("there is no mesh " + Text.quoted(name) + "; name a mesh file, or one of "
                    + String.join(", ", BuiltInMeshes.names()));
        }
        return read(file, unit);
    }

    /** Throws an {@link InputException} for damaged files; the message does not name the file. */
    private static GltfFile.Content parse(Path file) throws IOException {
        String head;
        try (InputStream stream = Files.newInputStream(file)) {
            head = new String(stream.readNBytes(HEAD_BYTES), StandardCharsets.ISO_8859_1);
        }
        if (head.startsWith("ply\n") || head.startsWith("ply\r")) {
            return new GltfFile.Content(PlyFile.read(file), Map.of());
        }
        // In Latin-1; a byte order mark in UTF-8 may precede JSON.
        boolean isGltf = head.startsWith(GltfDocument.MAGIC)
                || head.replaceFirst("^\u00ef\u00bb\u00bf", "").strip().startsWith("{");
        // OBJ has no signature.
        return isGltf ? GltfFile.read(file) : new GltfFile.Content(ObjFile.read(file), Map.of());
    }

    static void requireSize(Path file) throws IOException {
        long bytes = Files.size(file);
        String most = " bytes; at most " + MOST_BYTES + " can be used, so simplify the mesh";
        InputException.refuseIf(bytes > MOST_BYTES, file.getFileName() + " has " + bytes + most);
    }

    /** Reads a file of at most 512 MiB, 2 million positions and 2 million triangles. */
    static Loaded read(Path file, Unit unit) {
        InputException.requireRegular(file);
        GltfFile.Content content = InputException.naming(file, () -> {
            requireSize(file);
            return parse(file);
        });
        RawMesh raw = content.whole().scaled(unit.meters);
        List<String> warnings = new ArrayList<>();
        Consumer<String> warning = line -> warnings.add(file + ": " + line);
        RawMesh mesh = raw.withoutDegenerate();
        int dropped = (raw.cornerCount() - mesh.cornerCount()) / 3;
        InputException.refuseIf(
                raw.cornerCount() == 0, file + " has no faces; name a mesh with faces as OBJ, PLY or glTF");
        InputException.refuseIf(mesh.cornerCount() == 0, file + " has no face with an area");
        if (dropped > 0) {
            warning.accept("dropped " + count(dropped, "triangle") + " without area");
        }
        Optional<Vector3d> far = mesh.farCenter();
        far.ifPresent(center -> warning.accept(Text.format(
                "it lies far from the origin, so its center (%.3f, %.3f, %.3f) m is moved there",
                center.x, center.y, center.z)));
        Mesh whole = complete(far.map(mesh::centered).orElse(mesh), unit, warning);
        List<Part> parts = far.isEmpty() ? parts(content.parts(), unit) : List.of();
        boolean areDrawable =
                parts.stream().map(part -> part.place().determinant3x3()).allMatch(MeshSource::isInvertible);
        return parts.isEmpty() || !areDrawable ? new Loaded(whole, warnings) : new Loaded(whole, parts, warnings);
    }

    /** Returns no parts if a mesh lacks texture coordinates, which the whole gets, or lies too far from its own origin for float32. */
    private static List<Part> parts(Map<RawMesh, List<Matrix4d>> placed, Unit unit) {
        if (placed.keySet().stream().anyMatch(mesh -> mesh.farCenter().isPresent() || isPlanar(mesh))) {
            return List.of();
        }
        List<Part> parts = new ArrayList<>();
        placed.forEach((raw, places) -> {
            Mesh mesh = new VertexAssembly(raw, false).assemble(line -> {});
            places.forEach(place -> parts.add(new Part(
                    mesh, new Matrix4f(new Matrix4d().scaling(unit.meters).mul(place)))));
        });
        return parts;
    }

    /** True for the volume of a unit cube under a matrix whose inverse float32 can hold. */
    public static boolean isInvertible(float volume) {
        return Math.abs(volume) >= Float.MIN_NORMAL && Math.abs(volume) <= 1 / Float.MIN_NORMAL;
    }

    private static boolean isPlanar(RawMesh mesh) {
        return IntStream.range(0, mesh.cornerCount()).anyMatch(corner -> mesh.textureCoordinate(corner) < 0);
    }

    private static Mesh complete(RawMesh mesh, Unit unit, Consumer<String> warning) {
        boolean planar = isPlanar(mesh);
        if (planar) {
            warning.accept("texture coordinates are missing; they are taken from above (x, y)");
        }
        Mesh whole = new VertexAssembly(planar ? mesh.withPlanarCoordinates() : mesh, planar).assemble(warning);
        warnOfSize(whole, unit, warning);
        return whole;
    }

    public static String count(int number, String noun) {
        String plural = noun.equals("vertex") ? "vertices" : noun + "s";
        return number + " " + (number == 1 ? noun : plural);
    }

    private static void warnOfSize(Mesh mesh, Unit unit, Consumer<String> warning) {
        double side = Math.max(mesh.side(0), Math.max(mesh.side(1), mesh.side(2)));
        if (isPlausible(side)) {
            return;
        }
        String remedy = Stream.of(Unit.MM, Unit.CM, Unit.IN, Unit.M, Unit.UM)
                .filter(other -> isPlausible(side / unit.meters * other.meters))
                .findFirst()
                .map(other -> other.name().toLowerCase(Locale.ROOT))
                .map(word -> "if its numbers are in " + word + ", give --mesh-unit " + word
                        + ", in a scene \"meshUnit\": \"" + word + "\"")
                .orElse("scale it");
        warning.accept("the mesh is " + Lengths.rounded(side, 3) + " wide, where " + Lengths.format(LEAST) + " to "
                + Lengths.format(MOST) + " make sense; " + remedy);
    }

    private static boolean isPlausible(double side) {
        return side >= LEAST && side <= MOST;
    }
}
