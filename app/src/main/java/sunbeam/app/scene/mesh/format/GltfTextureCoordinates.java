package sunbeam.app.scene.mesh.format;

import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.Material;
import de.javagl.jgltf.impl.v2.MaterialPbrMetallicRoughness;
import de.javagl.jgltf.impl.v2.MeshPrimitive;
import de.javagl.jgltf.impl.v2.TextureInfo;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.joml.Vector2d;
import sunbeam.app.files.input.InputException;

/**
 * The texture coordinates of a primitive: the set that its material's first texture uses, transformed by its extension
 * KHR_texture_transform. Without a texture they are the first set, not transformed.
 *
 * @param set number n of the attribute TEXCOORD_n
 * @param rotation radians
 */
record GltfTextureCoordinates(int set, Vector2d offset, double rotation, Vector2d scale) {
    private static final String TRANSFORM = "KHR_texture_transform";

    static GltfTextureCoordinates of(Path file, GlTF gltf, MeshPrimitive primitive) {
        List<Material> materials = gltf.getMaterials();
        Integer index = primitive.getMaterial();
        boolean hasMaterial = index != null && materials != null && index >= 0 && index < materials.size();
        TextureInfo texture = hasMaterial ? firstTexture(materials.get(index)) : null;
        int set = texture == null || texture.getTexCoord() == null ? 0 : texture.getTexCoord();
        Map<String, Object> extensions = texture == null ? null : texture.getExtensions();
        if (extensions == null || !extensions.containsKey(TRANSFORM)) {
            return new GltfTextureCoordinates(set, new Vector2d(), 0, new Vector2d(1));
        }
        if (!(extensions.get(TRANSFORM) instanceof Map<?, ?> transform)) {
            throw damaged(file);
        }
        Object ownSet = transform.containsKey("texCoord") ? transform.get("texCoord") : set;
        Object rotation = transform.containsKey("rotation") ? transform.get("rotation") : 0;
        if (!(ownSet instanceof Integer number) || !(rotation instanceof Number radians)) {
            throw damaged(file);
        }
        return new GltfTextureCoordinates(
                number,
                pair(file, transform, "offset", new Vector2d()),
                radians.doubleValue(),
                pair(file, transform, "scale", new Vector2d(1)));
    }

    private static TextureInfo firstTexture(Material material) {
        MaterialPbrMetallicRoughness surface = material.getPbrMetallicRoughness();
        return Stream.of(
                        surface == null ? null : surface.getBaseColorTexture(),
                        material.getNormalTexture(),
                        surface == null ? null : surface.getMetallicRoughnessTexture(),
                        material.getEmissiveTexture())
                .filter(Objects::nonNull)
                .findFirst()
                .orElse(null);
    }

    private static Vector2d pair(Path file, Map<?, ?> transform, String key, Vector2d fallback) {
        if (!transform.containsKey(key)) {
            return fallback;
        }
        if (transform.get(key) instanceof List<?> list
                && list.size() == 2
                && list.get(0) instanceof Number x
                && list.get(1) instanceof Number y) {
            return new Vector2d(x.doubleValue(), y.doubleValue());
        }
        throw damaged(file);
    }

    private static InputException damaged(Path file) {
        return new InputException(file + ": its " + TRANSFORM + " cannot be understood; export it again without");
    }

    String attribute() {
        return "TEXCOORD_" + set;
    }

    /**
     * Transforms a texture coordinate (v downwards): scales, rotates, then moves it. The rotation is counter-clockwise in the picture, as
     * in the extension's first example; the extension's formula has the other sign.
     */
    Vector2d transform(double u, double v) {
        double x = scale.x * u;
        double y = scale.y * v;
        double cosine = Math.cos(rotation);
        double sine = Math.sin(rotation);
        return new Vector2d(cosine * x + sine * y + offset.x, cosine * y - sine * x + offset.y);
    }
}
