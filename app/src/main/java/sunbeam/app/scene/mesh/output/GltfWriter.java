package sunbeam.app.scene.mesh.output;

import static de.javagl.jgltf.model.GltfConstants.GL_ARRAY_BUFFER;
import static de.javagl.jgltf.model.GltfConstants.GL_ELEMENT_ARRAY_BUFFER;
import static de.javagl.jgltf.model.GltfConstants.GL_FLOAT;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_INT;

import de.javagl.jgltf.impl.v2.Accessor;
import de.javagl.jgltf.impl.v2.Asset;
import de.javagl.jgltf.impl.v2.Buffer;
import de.javagl.jgltf.impl.v2.BufferView;
import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.Image;
import de.javagl.jgltf.impl.v2.Material;
import de.javagl.jgltf.impl.v2.MaterialNormalTextureInfo;
import de.javagl.jgltf.impl.v2.MaterialPbrMetallicRoughness;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import de.javagl.jgltf.impl.v2.Node;
import de.javagl.jgltf.impl.v2.Scene;
import de.javagl.jgltf.impl.v2.Texture;
import de.javagl.jgltf.impl.v2.TextureInfo;
import de.javagl.jgltf.model.io.v2.GltfAssetV2;
import de.javagl.jgltf.model.io.v2.GltfAssetWriterV2;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.Optional;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.terminal.Version;

/**
 * Writes a mesh as binary glTF 2.0: positions in meters, y up ((x, y, z) as (x, z, -y)), texture coordinates with v downwards, normals,
 * tangents, and the skin as its material.
 */
public final class GltfWriter {
    // Roughness of skin below its nanostructure: neither a mirror nor chalk.
    private static final float ROUGHNESS = 0.5f;

    private final GlTF gltf = new GlTF();
    private final ByteArrayOutputStream binary = new ByteArrayOutputStream();

    private GltfWriter() {}

    /** Writes the file; the stream stays open. */
    public static void write(OutputStream stream, Mesh mesh, Optional<SkinMaps> maps) throws IOException {
        GltfWriter writer = new GltfWriter();
        writer.add(mesh, maps);
        ByteBuffer content = ByteBuffer.wrap(writer.binary.toByteArray());
        new GltfAssetWriterV2().writeBinary(new GltfAssetV2(writer.gltf, content), stream);
    }

    private void add(Mesh mesh, Optional<SkinMaps> maps) throws IOException {
        Asset asset = new Asset();
        asset.setVersion("2.0");
        asset.setGenerator("Sunbeam " + Version.number());
        gltf.setAsset(asset);
        MeshPrimitive primitive = new MeshPrimitive();
        primitive.addAttributes("POSITION", positions(toYUp(mesh.positions(), 3)));
        primitive.addAttributes("NORMAL", floats(toYUp(mesh.normals(), 3), 3));
        primitive.addAttributes("TANGENT", floats(toYUp(mesh.tangents(), 4), 4));
        primitive.addAttributes("TEXCOORD_0", floats(flipV(mesh.textureCoordinates()), 2));
        primitive.setIndices(indices(mesh.indices()));
        primitive.setMaterial(material(mesh, maps));
        de.javagl.jgltf.impl.v2.Mesh all = new de.javagl.jgltf.impl.v2.Mesh();
        all.addPrimitives(primitive);
        gltf.addMeshes(all);
        Node node = new Node();
        node.setMesh(0);
        gltf.addNodes(node);
        Scene scene = new Scene();
        scene.addNodes(0);
        gltf.addScenes(scene);
        gltf.setScene(0);
        Buffer buffer = new Buffer();
        buffer.setByteLength(binary.size());
        gltf.addBuffers(buffer);
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

    /** Adds positions with their bounds, which glTF requires. */
    private int positions(float[] positions) {
        int accessor = floats(positions, 3);
        Number[] least = {positions[0], positions[1], positions[2]};
        Number[] most = least.clone();
        for (int i = 0; i < positions.length; i++) {
            least[i % 3] = (double) Math.min(least[i % 3].floatValue(), positions[i]);
            most[i % 3] = (double) Math.max(most[i % 3].floatValue(), positions[i]);
        }
        gltf.getAccessors().get(accessor).setMin(least);
        gltf.getAccessors().get(accessor).setMax(most);
        return accessor;
    }

    private int floats(float[] values, int components) {
        ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(values);
        return accessor(view(bytes.array(), GL_ARRAY_BUFFER), GL_FLOAT, "VEC" + components, values.length / components);
    }

    private int indices(int[] indices) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * indices.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asIntBuffer().put(indices);
        return accessor(view(bytes.array(), GL_ELEMENT_ARRAY_BUFFER), GL_UNSIGNED_INT, "SCALAR", indices.length);
    }

    private int accessor(int view, int componentType, String type, int count) {
        Accessor accessor = new Accessor();
        accessor.setBufferView(view);
        accessor.setComponentType(componentType);
        accessor.setType(type);
        accessor.setCount(count);
        gltf.addAccessors(accessor);
        return gltf.getAccessors().size() - 1;
    }

    private int view(byte[] content, Integer target) {
        BufferView view = new BufferView();
        view.setBuffer(0);
        view.setByteOffset(binary.size());
        view.setByteLength(content.length);
        view.setTarget(target);
        gltf.addBufferViews(view);
        binary.writeBytes(content);
        // The next view begins at a multiple of four bytes, as glTF requires.
        binary.writeBytes(new byte[(4 - content.length % 4) % 4]);
        return gltf.getBufferViews().size() - 1;
    }

    private int material(Mesh mesh, Optional<SkinMaps> maps) throws IOException {
        MaterialPbrMetallicRoughness skin = new MaterialPbrMetallicRoughness();
        skin.setMetallicFactor(0f);
        skin.setRoughnessFactor(ROUGHNESS);
        Material material = new Material();
        material.setPbrMetallicRoughness(skin);
        material.setDoubleSided(!mesh.closed());
        if (maps.isPresent()) {
            TextureInfo albedo = new TextureInfo();
            albedo.setIndex(texture(maps.get().albedo()));
            skin.setBaseColorTexture(albedo);
            if (maps.get().normals().isPresent()) {
                MaterialNormalTextureInfo normals = new MaterialNormalTextureInfo();
                normals.setIndex(texture(maps.get().normals().get()));
                material.setNormalTexture(normals);
            }
        }
        gltf.addMaterials(material);
        return 0;
    }

    private int texture(BufferedImage picture) throws IOException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        PngWriter.write(png, picture, Map.of());
        Image image = new Image();
        image.setMimeType("image/png");
        image.setBufferView(view(png.toByteArray(), null));
        gltf.addImages(image);
        Texture texture = new Texture();
        texture.setSource(gltf.getImages().size() - 1);
        gltf.addTextures(texture);
        return gltf.getTextures().size() - 1;
    }
}
