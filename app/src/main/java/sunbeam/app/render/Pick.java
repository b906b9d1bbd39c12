package sunbeam.app.render;

import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.precompute.optics.Direction;

/**
 * Point of the skin under a pixel, the shader's tangent frame there (with relief and the patch's rotation), and the directions to light and
 * viewer in that frame.
 *
 * @param position meters, world space
 * @param region index of the point's patch in the scene
 * @param center center of the mesh, about which a scene's orientation turns the mesh, meters, world space
 * @param tangent unit vector, world space
 * @param bitangent unit vector, world space
 * @param normal unit vector, world space
 * @param wi unit vector towards the light, tangent frame; z is negative if the light is behind the skin
 * @param wr unit vector towards the viewer, tangent frame; z may be negative where relief turns the normal away
 */
public record Pick(
        Vector3fc position,
        int region,
        Vector3fc center,
        Vector3fc tangent,
        Vector3fc bitangent,
        Vector3fc normal,
        Direction wi,
        Direction wr) {

    public Pick {
        position = new Vector3f(position);
        center = new Vector3f(center);
        tangent = new Vector3f(tangent);
        bitangent = new Vector3f(bitangent);
        normal = new Vector3f(normal);
    }
}
