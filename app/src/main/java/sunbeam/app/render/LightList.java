package sunbeam.app.render;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import jrtr.scene.Light;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.environment.LightTree;
import sunbeam.app.scene.environment.RadianceMap;

/**
 * Lights of a picture, in groups of neighbors that share a shadow map (shaders/include/light_list.glsl).
 *
 * @param areDrawn whether each draw of a pixel has one of them, at random, instead of all
 * @param skyWeight factor of the surroundings' radiance, which gloss mirrors and the ground fades to; 0 for none
 */
record LightList(List<Group> groups, boolean areDrawn, double skyWeight) {
    /** Mesa's software renderer ends a shader's loops after 65,535 steps; a light takes up to 25. */
    static final int MOST = LightTree.MOST + 256;

    // Share of all light of the weakest light that every sample of a pixel has; at most 64 reach it.
    private static final double BRIGHT = 1 / 64.0;

    /** Lights of an environment under which all samples of a pixel have all lights. */
    static final int FEW = 16;

    // Lights of an environment in a still picture of a scene that gives no number.
    private static final int STILL = 128;
    // Width of a region's light over the region's own: a row of such Gaussians is even to 2 exp(-2 pi^2 2^2 / 12) = 0.3
    // %.
    static final double OVERLAP = 2;

    /** MOST_GROUPS of the shader. */
    static final int MOST_GROUPS = 17;

    // Groups of an environment; shadows of a small group are sharp.
    private static final int ENVIRONMENT_GROUPS = 16;
    private static final double SHARPEST_PENUMBRA = 0.01;

    /** Radius of the edge of a shadow per distance from its caster, for lights of a scene. */
    private static final double SCENE_PENUMBRA = 0.05;

    /**
     * @param middle unit vector along the group's shadows
     * @param penumbra radius of a shadow's edge per distance from its caster; 0 for a group without shadows
     */
    record Group(List<Light> lights, Vector3fc middle, double penumbra) {
        boolean hasShadows() {
            return penumbra > 0;
        }

        /** Returns the linear Rec. 709 of a white plane under these lights, without shadows. */
        Vector3f onPlane(Vector3fc normal) {
            Vector3f sum = new Vector3f();
            lights.forEach(light -> sum.fma(Math.max(0, light.towards().dot(normal)), light.radiance()));
            return sum;
        }
    }

    /** Returns lights that add up to one, one for each of the samples that have different lights. */
    private static Stream<Light> shared(Light light) {
        Light part = light.withRadiance(light.radiance().div(SkinSurface.LIGHT_STRIDE, new Vector3f()));
        return Stream.generate(() -> part).limit(SkinSurface.LIGHT_STRIDE);
    }

    /** Returns an environment's lights, or the scene's own, the first group those of the key light; fill lights cast no shadows. */
    static LightList of(Scene scene, Optional<RadianceMap> environment) {
        return environment.map(map -> of(scene, map.lights(), false)).orElseGet(() -> own(scene));
    }

    /** Does what {@link #of} does, with few lights of an environment. */
    static LightList moving(Scene scene, Optional<RadianceMap> environment) {
        return environment.map(map -> of(scene, map.lights(), true)).orElseGet(() -> own(scene));
    }

    /** Returns the brightest of the lights of an environment in a still picture; if the ground hides all of them, a dark one below it. */
    static SceneLight brightest(Scene scene, RadianceMap environment) {
        Vector3f up = new Vector3f(0, 0, 1).rotate(new Quaternionf(scene.orientation()));
        return environment.lights().groups(stillLights(scene), 1).stream()
                .flatMap(region -> above(scene, region, up))
                .max(Comparator.comparingDouble(LightTree::luminance))
                .map(light -> new SceneLight(light.towards(), LightTree.luminance(light), 4 * light.deviation()))
                .orElseGet(() -> new SceneLight(up.negate(), 0, 0));
    }

    private static int stillLights(Scene scene) {
        return scene.get(SceneSettings.ENVIRONMENT_LIGHTS).orElse(STILL);
    }

    private static LightList of(Scene scene, LightTree tree, boolean moves) {
        boolean areDrawn = !moves && !hasFootprints(scene);
        int count = moves ? SceneSession.MOVING_LIGHTS : stillLights(scene);
        Vector3f up = new Vector3f(0, 0, 1).rotate(new Quaternionf(scene.orientation()));
        float intensity = scene.get(SceneSettings.ENVIRONMENT_INTENSITY).floatValue();
        List<LightTree.Group> regions =
                areDrawn ? tree.pixels(ENVIRONMENT_GROUPS) : tree.groups(count, ENVIRONMENT_GROUPS);
        // Shadows have the same directions under any number of lights.
        List<List<Light>> finest = tree.groups(LightTree.MOST, ENVIRONMENT_GROUPS).stream()
                .map(region -> above(scene, region, up).toList())
                .toList();
        double bright = moves || areDrawn
                ? Double.POSITIVE_INFINITY
                : BRIGHT
                        * finest.stream()
                                .flatMap(List::stream)
                                .mapToDouble(LightTree::luminance)
                                .sum();
        List<Group> groups = new ArrayList<>();
        for (int i = 0; i < regions.size(); i++) {
            List<Light> lights = above(scene, regions.get(i), up)
                    .flatMap(light -> LightTree.luminance(light) < bright ? Stream.of(light) : shared(light))
                    .toList();
            if (!lights.isEmpty()) {
                boolean hasShadows = scene.hasShadows() && !moves;
                double softest = Math.max(SHARPEST_PENUMBRA, 2 * regions.get(i).deviation());
                groups.add(new Group(
                        lights, middle(finest.get(i).isEmpty() ? lights : finest.get(i)), hasShadows ? softest : 0));
            }
        }
        if (groups.isEmpty()) {
            groups.add(new Group(List.of(new Light(up, new Vector3f(), 0, new Vector3f())), up, 0));
        }
        return new LightList(groups, areDrawn, intensity);
    }

    /** Returns a region's lights that no ground hides. */
    private static Stream<Light> above(Scene scene, LightTree.Group region, Vector3fc up) {
        float intensity = scene.get(SceneSettings.ENVIRONMENT_INTENSITY).floatValue();
        List<Light> leaves = region.lights().stream()
                .map(light -> new Light(
                        light.towards(),
                        light.radiance().mul(intensity, new Vector3f()),
                        light.deviation(),
                        light.stretch()))
                .toList();
        return SceneGraph.environment(scene, leaves).lights().stream()
                .filter(light -> scene.ground().isEmpty() || light.towards().dot(up) > 0);
    }

    /** Returns the mean direction of lights by luminance, or that of the first light if they cancel. */
    private static Vector3f middle(List<Light> lights) {
        Vector3f sum = new Vector3f();
        lights.forEach(light -> sum.fma((float) LightTree.luminance(light), light.towards()));
        return sum.length() > 0 ? sum.normalize() : sum.set(lights.get(0).towards());
    }

    private static LightList own(Scene scene) {
        List<Group> groups = new ArrayList<>();
        Vector3fc key = scene.light().towards();
        groups.add(new Group(drawn(scene, scene.light()).toList(), key, scene.hasShadows() ? SCENE_PENUMBRA : 0));
        if (!scene.fillLights().isEmpty()) {
            List<Light> fill = scene.fillLights().stream()
                    .flatMap(light -> drawn(scene, light))
                    .toList();
            groups.add(new Group(fill, key, 0));
        }
        double intensity =
                scene.lights().stream().mapToDouble(SceneLight::intensity).sum();
        return new LightList(groups, false, scene.sky() * intensity);
    }

    private static boolean hasFootprints(Scene scene) {
        return scene.method().isTable() && !scene.method().isThesis();
    }

    /** Footprints show lights of one direction: a wide light becomes several. */
    private static Stream<Light> drawn(Scene scene, SceneLight light) {
        List<SceneLight> parts = hasFootprints(scene) ? light.narrow() : List.of(light);
        return parts.stream()
                .map(part -> new Light(
                        part.towards(), new Vector3f((float) part.intensity()), scene.deviation(part), new Vector3f()));
    }

    List<Light> all() {
        return groups.stream().flatMap(group -> group.lights().stream()).toList();
    }

    /** Luminance of a white surface that faces the brightest side, without shadows. */
    double white() {
        return LightTree.white(all());
    }

    int count() {
        return groups.stream().mapToInt(group -> group.lights().size()).sum();
    }

    /** True if samples of a pixel have different lights. */
    boolean areShared() {
        return count() > FEW * SkinSurface.LIGHT_STRIDE;
    }

    /** True for more lights than a scene has without environment. */
    boolean areMany() {
        return count() > Light.MOST;
    }

    /** True for lights of {@link LightCount#finest}, under which nothing is approximated. */
    boolean areFinest() {
        return count() > MOST;
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
                Light alone = group.lights().get(light - first);
                double share = LightTree.luminance(alone)
                        / all().stream().mapToDouble(LightTree::luminance).sum();
                return new LightList(
                        List.of(new Group(List.of(alone), group.middle(), group.penumbra())),
                        areDrawn,
                        share > 0 ? share * skyWeight : 0);
            }
            first = end;
        }
        throw new IndexOutOfBoundsException("light " + light + " of " + first);
    }
}
