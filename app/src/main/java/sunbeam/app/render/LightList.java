package sunbeam.app.render;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.precompute.method.TableMethod;

/** Lights of a picture, in groups of neighbors that share a shadow map (shaders/include/light_list.glsl). */
record LightList(List<Group> groups) {
    /** Mesa's software renderer ends a shader's loops after 65,535 steps; a light takes up to 25. */
    static final int MOST = 2048;

    /** MOST_GROUPS of the shader. */
    static final int MOST_GROUPS = 17;

    /** Radius of the edge of a shadow per distance from its caster, for lights of a scene. */
    private static final double SCENE_PENUMBRA = 0.05;

    /**
     * @param towards unit vector from the scene, world space
     * @param color radiance of a white surface that faces the light, linear Rec. 709
     * @param deviation standard deviation of its directions along either axis across it, radians
     */
    record Light(Vector3fc towards, Vector3fc color, double deviation) {
        double luminance() {
            return 0.2126729 * color.x() + 0.7151522 * color.y() + 0.0721750 * color.z();
        }
    }

    /** @param penumbra radius of a shadow's edge per distance from its caster; 0 for a group without shadows */
    record Group(List<Light> lights, double penumbra) {
        boolean hasShadows() {
            return penumbra > 0;
        }

        /** Direction of the group's shadows: the mean of its lights by luminance, or its first light if they cancel. */
        Vector3f middle() {
            Vector3f sum = new Vector3f();
            lights.forEach(light -> sum.fma((float) light.luminance(), light.towards()));
            return sum.length() > 0 ? sum.normalize() : sum.set(lights.get(0).towards());
        }

        /** Returns the linear Rec. 709 of a white plane under these lights, without shadows. */
        Vector3f onPlane(Vector3fc normal) {
            Vector3f sum = new Vector3f();
            lights.forEach(light -> sum.fma(Math.max(0, light.towards().dot(normal)), light.color()));
            return sum;
        }
    }

    /** Returns a scene's lights, the first group those of the key light; fill lights cast no shadows. */
    static LightList of(Scene scene) {
        List<Group> groups = new ArrayList<>();
        groups.add(new Group(drawn(scene, scene.light()).toList(), scene.hasShadows() ? SCENE_PENUMBRA : 0));
        if (!scene.fillLights().isEmpty()) {
            List<Light> fill = scene.fillLights().stream()
                    .flatMap(light -> drawn(scene, light))
                    .toList();
            groups.add(new Group(fill, 0));
        }
        return new LightList(groups);
    }

    /** Footprints show lights of one direction: a wide light becomes several. */
    private static Stream<Light> drawn(Scene scene, SceneLight light) {
        boolean hasFootprints = scene.method().type().equals(TableMethod.TYPE)
                && !scene.method().isThesis();
        List<SceneLight> parts = hasFootprints ? light.narrow() : List.of(light);
        return parts.stream()
                .map(part -> new Light(part.towards(), new Vector3f((float) part.intensity()), scene.deviation(part)));
    }

    List<Light> all() {
        return groups.stream().flatMap(group -> group.lights().stream()).toList();
    }

    int count() {
        return groups.stream().mapToInt(group -> group.lights().size()).sum();
    }

    boolean areWide() {
        return groups.stream().flatMap(group -> group.lights().stream()).anyMatch(light -> light.deviation() > 0);
    }

    /** Returns one light alone, in its group. */
    LightList only(int light) {
        int first = 0;
        for (Group group : groups) {
            int end = first + group.lights().size();
            if (light < end) {
                return new LightList(List.of(new Group(List.of(group.lights().get(light - first)), group.penumbra())));
            }
            first = end;
        }
        throw new IndexOutOfBoundsException("light " + light + " of " + first);
    }
}
