package sunbeam.app.scene.mesh;

import static de.javagl.jgltf.model.GltfConstants.GL_ARRAY_BUFFER;
import static de.javagl.jgltf.model.GltfConstants.GL_ELEMENT_ARRAY_BUFFER;
import static de.javagl.jgltf.model.GltfConstants.GL_FLOAT;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_INT;

import com.fasterxml.jackson.databind.ObjectMapper;
import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.model.io.v2.GltfAssetV2;
import de.javagl.jgltf.model.io.v2.GltfAssetWriterV2;
import java.awt.image.BufferedImage;
import java.io.BufferedWriter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.text.Text;

/** Writers of meshes to streams, which stay open. */
public final class MeshWriters {
    private static final int VERTEX_BYTES = 8 * Float.BYTES;
    private static final int FACE_BYTES = 1 + 3 * Integer.BYTES;

    private MeshWriters() {}

    /** Writes Wavefront OBJ, without tangents; each number is the shortest decimal that reads back as the same float. */
    public static void obj(OutputStream stream, Mesh mesh) throws IOException {
        // Unbuffered, writing takes twice as long.
        Writer writer = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.US_ASCII));
        writer.write(
                "# Sunbeam mesh: meters, z up; " + mesh.vertices() + " vertices, " + mesh.triangles() + " triangles\n");
        writeLines(writer, "v", mesh.positions(), 3);
        writeLines(writer, "vt", mesh.textureCoordinates(), 2);
        writeLines(writer, "vn", mesh.normals(), 3);
        for (int i = 0; i < mesh.indices().length; i += 3) {
            writer.write("f");
            for (int corner = i; corner < i + 3; corner++) {
                String number = Integer.toString(mesh.indices()[corner] + 1);
                writer.write(" " + number + "/" + number + "/" + number);
            }
            writer.write('\n');
        }
        writer.flush();
    }

    private static void writeLines(Writer writer, String kind, float[] values, int perLine) throws IOException {
        for (int i = 0; i < values.length; i += perLine) {
            writer.write(kind);
            for (int j = i; j < i + perLine; j++) {
                writer.write(" " + values[j]);
            }
            writer.write('\n');
        }
    }

    /** Writes binary PLY, little-endian: positions in meters, normals and texture coordinates, without tangents. */
    public static void ply(OutputStream stream, Mesh mesh) throws IOException {
        String header = Text.format("""
                ply
                format binary_little_endian 1.0
                comment Sunbeam mesh: meters, z up
                element vertex %d
                property float x
                property float y
                property float z
                property float nx
                property float ny
                property float nz
                property float s
                property float t
                element face %d
                property list uchar int vertex_indices
                end_header
                """, mesh.vertices(), mesh.triangles());
        ByteBuffer bytes = ByteBuffer.allocate(VERTEX_BYTES * mesh.vertices() + FACE_BYTES * mesh.triangles())
                .order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < mesh.vertices(); i++) {
            put(bytes, mesh.positions(), 3 * i, 3);
            put(bytes, mesh.normals(), 3 * i, 3);
            put(bytes, mesh.textureCoordinates(), 2 * i, 2);
        }
        for (int i = 0; i < mesh.indices().length; i++) {
            if (i % 3 == 0) {
                bytes.put((byte) 3);
            }
            bytes.putInt(mesh.indices()[i]);
        }
        stream.write(header.getBytes(StandardCharsets.US_ASCII));
        stream.write(bytes.array());
    }

    private static void put(ByteBuffer bytes, float[] values, int from, int count) {
        for (int i = from; i < from + count; i++) {
            bytes.putFloat(values[i]);
        }
    }

    /** Writes binary glTF 2.0: y up ((x, y, z) as (x, z, -y)), v downwards, with tangents and the skin as its material. */
    public static void glb(OutputStream stream, Mesh mesh, Optional<SkinMaps> maps) throws IOException {
        Gltf writer = new Gltf();
        GlTF gltf = new ObjectMapper().convertValue(writer.document(mesh, maps), GlTF.class);
        ByteBuffer content = ByteBuffer.wrap(writer.binary.toByteArray());
        new GltfAssetWriterV2().writeBinary(new GltfAssetV2(gltf, content), stream);
    }

    private static final class Gltf {
        // Skin below its nanostructure: neither mirror nor chalk.
        private static final double ROUGHNESS = 0.5;

        private final List<Map<String, ?>> accessors = new ArrayList<>();
        private final List<Map<String, ?>> views = new ArrayList<>();
        private final List<Map<String, ?>> images = new ArrayList<>();
        private final List<Map<String, ?>> textures = new ArrayList<>();
        private final ByteArrayOutputStream binary = new ByteArrayOutputStream();

        private Map<String, ?> document(Mesh mesh, Optional<SkinMaps> maps) throws IOException {
            Map<String, ?> attributes = Map.of(
                    "POSITION", positions(toYUp(mesh.positions(), 3)),
                    "NORMAL", floats(toYUp(mesh.normals(), 3), 3, Map.of()),
                    "TANGENT", floats(toYUp(mesh.tangents(), 4), 4, Map.of()),
                    "TEXCOORD_0", floats(flipV(mesh.textureCoordinates()), 2, Map.of()));
            Map<String, ?> primitive =
                    Map.of("attributes", new TreeMap<>(attributes), "indices", indices(mesh.indices()), "material", 0);
            Map<String, Object> document = new TreeMap<>();
            document.put("asset", Map.of("version", "2.0", "generator", "Sunbeam " + Environment.version()));
            document.put("scene", 0);
            document.put("scenes", List.of(Map.of("nodes", List.of(0))));
            document.put("nodes", List.of(Map.of("mesh", 0)));
            document.put("meshes", List.of(Map.of("primitives", List.of(primitive))));
            document.put("materials", List.of(material(mesh, maps)));
            document.put("accessors", accessors);
            document.put("bufferViews", views);
            document.put("buffers", List.of(Map.of("byteLength", binary.size())));
            if (!images.isEmpty()) {
                document.put("images", images);
                document.put("textures", textures);
            }
            return document;
        }

        private static float[] toYUp(float[] vectors, int components) {
            float[] turned = vectors.clone();
            for (int i = 0; i < turned.length; i += components) {
                turned[i + 1] = vectors[i + 2];
                turned[i + 2] = -vectors[i + 1];
            }
            return turned;
        }

        private static float[] flipV(float[] coordinates) {
            float[] turned = coordinates.clone();
            for (int i = 1; i < turned.length; i += 2) {
                turned[i] = 1 - turned[i];
            }
            return turned;
        }

        private int positions(float[] positions) {
            float[] least = {positions[0], positions[1], positions[2]};
            float[] most = least.clone();
            for (int i = 0; i < positions.length; i++) {
                least[i % 3] = Math.min(least[i % 3], positions[i]);
                most[i % 3] = Math.max(most[i % 3], positions[i]);
            }
            return floats(positions, 3, Map.of("min", least, "max", most));
        }

        private int floats(float[] values, int components, Map<String, ?> bounds) {
            ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
            bytes.asFloatBuffer().put(values);
            int view = view(bytes.array(), Map.of("target", GL_ARRAY_BUFFER));
            return accessor(view, GL_FLOAT, "VEC" + components, values.length / components, bounds);
        }

        private int indices(int[] indices) {
            ByteBuffer bytes =
                    ByteBuffer.allocate(Integer.BYTES * indices.length).order(ByteOrder.LITTLE_ENDIAN);
            bytes.asIntBuffer().put(indices);
            int view = view(bytes.array(), Map.of("target", GL_ELEMENT_ARRAY_BUFFER));
            return accessor(view, GL_UNSIGNED_INT, "SCALAR", indices.length, Map.of());
        }

        private int accessor(int view, int componentType, String type, int count, Map<String, ?> bounds) {
            Map<String, Object> accessor = new TreeMap<>(bounds);
            accessor.putAll(Map.of("bufferView", view, "componentType", componentType, "type", type, "count", count));
            accessors.add(accessor);
            return accessors.size() - 1;
        }

        private int view(byte[] content, Map<String, ?> target) {
            Map<String, Object> view = new TreeMap<>(target);
            view.putAll(Map.of("buffer", 0, "byteOffset", binary.size(), "byteLength", content.length));
            views.add(view);
            binary.writeBytes(content);
            // glTF requires multiples of four bytes.
            binary.writeBytes(new byte[(4 - content.length % 4) % 4]);
            return views.size() - 1;
        }

        private Map<String, ?> material(Mesh mesh, Optional<SkinMaps> maps) throws IOException {
            Map<String, Object> skin = new TreeMap<>(Map.of("metallicFactor", 0, "roughnessFactor", ROUGHNESS));
            Map<String, Object> material = new TreeMap<>(Map.of("pbrMetallicRoughness", skin));
            material.put("doubleSided", !mesh.closed());
            if (maps.isPresent()) {
                skin.put("baseColorTexture", texture(maps.get().albedo()));
                if (maps.get().normals().isPresent()) {
                    material.put("normalTexture", texture(maps.get().normals().get()));
                }
            }
            return material;
        }

        private Map<String, ?> texture(BufferedImage picture) throws IOException {
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            PngWriter.write(png, picture, Map.of());
            textures.add(Map.of("source", images.size()));
            images.add(Map.of("mimeType", "image/png", "bufferView", view(png.toByteArray(), Map.of())));
            return Map.of("index", images.size() - 1);
        }
    }
}
