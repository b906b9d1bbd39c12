package sunbeam.app.render;

import org.joml.Vector3fc;
import sunbeam.precompute.optics.Direction;

/**
 * Point of the skin under a pixel and its tangent frame, with relief and the patch's rotation. Unit vectors.
 *
 * @param position meters, world space
 * @param object index of the point's object in the scene
 * @param region index of the point's patch in the object
 * @param center center of the model, about which a scene's orientation turns it, meters, world space
 * @param tangent world space, as bitangent and normal
 * @param wi towards the light, tangent frame; z is negative if the light is behind the skin
 * @param wr towards the viewer, tangent frame; z may be negative where relief turns the normal away
 */
public record Pick(
        Vector3fc position,
        int object,
        int region,
        Vector3fc center,
        Vector3fc tangent,
        Vector3fc bitangent,
        Vector3fc normal,
        Direction wi,
        Direction wr) {}
