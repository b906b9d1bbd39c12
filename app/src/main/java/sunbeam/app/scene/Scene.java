package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.scene.Light;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import sunbeam.app.scene.SceneSettings.BodyAlpha;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.Scales;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Primaries;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * All that determines a picture except its size. File names are absolute. Settings and patches are those of the current object.
 *
 * @param settings values or defaults of all {@link SceneSettings} except those of patch, view and light
 * @param orientation rotation of all objects about the center of the sphere around them; unit length
 * @param fillLights further lights, which cast no shadows; at most {@link #MOST_FILL_LIGHTS}
 * @param objects all objects, the current one too; 1 to {@link SceneObject#MOST}
 * @param current index of the current object
 */
public record Scene(
        Choices settings,
        PatchAtlas patches,
        Viewpoint view,
        Quaternionfc orientation,
        SceneLight light,
        List<SceneLight> fillLights,
        SceneMethod method,
        List<SceneObject> objects,
        int current) {
    /** The shaders' limit of lights, less the key light. */
    public static final int MOST_FILL_LIGHTS = Light.MOST - 1;

    // Directions metered around the light's: number, and tangent of their angle to it, wider than orders' streaks.
    private static final int METER_TILTS = 4;
    private static final double METER_TILT = Math.tan(Math.toRadians(25));

    private static final Choices STANDARD = SceneSettings.standards(SceneSettings.OF_RECORD);

    public Scene {
        orientation = new Quaternionf(orientation);
        fillLights = List.copyOf(fillLights);
        settings = settings.only(SceneSettings.OF_RECORD).over(STANDARD);
        var object = new SceneObject(
                settings.only(SceneSettings.OF_OBJECT),
                patches,
                objects.get(current).placement());
        if (!object.equals(objects.get(current))) {
            objects = new ArrayList<>(objects);
            objects.set(current, object);
        }
        objects = List.copyOf(objects);
    }

    /** A scene of one object, with its mesh where the mesh's file has it. */
    public Scene(
            Choices settings,
            PatchAtlas patches,
            Viewpoint view,
            Quaternionfc orientation,
            SceneLight light,
            List<SceneLight> fillLights,
            SceneMethod method) {
        this(settings, patches, view, orientation, light, fillLights, method, List.of(one(patches)), 0);
    }

    private static SceneObject one(PatchAtlas patches) {
        return new SceneObject(Choices.none(), patches, Placement.NONE);
    }

    /** Returns the scene with another list of objects, of which the first is the current one. */
    public Scene withObjects(List<SceneObject> value) {
        SceneObject first = value.get(0);
        Choices own = first.settings().over(settings.without(SceneSettings.OF_OBJECT));
        return new Scene(own, first.patches(), view, orientation, light, fillLights, method, value, 0);
    }

    /** Returns the scene with another current object. */
    public Scene at(int index) {
        if (index == current) {
            return this;
        }
        SceneObject other = objects.get(index);
        Choices own = other.settings().over(settings.without(SceneSettings.OF_OBJECT));
        return new Scene(own, other.patches(), view, orientation, light, fillLights, method, objects, index);
    }

    /** Applies a change of the current object to each object. */
    public Scene each(UnaryOperator<Scene> change) {
        Scene changed = this;
        for (int i = 0; i < objects.size(); i++) {
            changed = change.apply(changed.at(i));
        }
        return changed.at(current);
    }

    /** Returns the scene once for each object, which is its current one. */
    public List<Scene> perObject() {
        return IntStream.range(0, objects.size()).mapToObj(this::at).toList();
    }

    /** Returns for each object the index of the first one that looks like it. */
    public List<Integer> looks() {
        Map<List<Object>, Integer> first = new HashMap<>();
        List<Integer> looks = new ArrayList<>();
        for (SceneObject object : objects) {
            looks.add(first.computeIfAbsent(object.look(), look -> looks.size()));
        }
        return looks;
    }

    /** True if ground and visible environment are drawn with the current object's look: it has the first body of all. */
    public boolean drawsGround() {
        return (ground().isPresent() || showsEnvironment())
                && hasBody()
                && objects.subList(0, current).stream().noneMatch(object -> hasBody(object.settings()));
    }

    /** Returns this scene with values of {@link SceneSettings} and {@link Methods#SETTINGS} in place of its own. */
    public Scene with(Choices chosen) {
        Choices inherited = chosen.has(SceneSettings.MESH) ? settings.without(SceneSettings.MESH_UNIT) : settings;
        double intensity = chosen.get(SceneSettings.INTENSITY, light.intensity());
        double diameter = chosen.get(SceneSettings.ANGULAR_DIAMETER, light.angularDiameter());
        SceneLight newLight = new SceneLight(light.towards(), intensity, diameter);
        SceneMethod newMethod = method.with(chosen.only(Methods.SETTINGS));
        return new Scene(
                chosen.over(inherited), patches, view, orientation, newLight, fillLights, newMethod, objects, current);
    }

    public <T> Scene with(Setting<T> setting, T value) {
        return new Scene(
                settings.with(setting, value), patches, view, orientation, light, fillLights, method, objects, current);
    }

    public Choices choices() {
        return settings.with(SceneSettings.TONE, display(1).tone())
                .with(SceneSettings.PRIMARIES, display(1).primaries())
                .with(SceneSettings.INTENSITY, light.intensity())
                .with(SceneSettings.ANGULAR_DIAMETER, light.angularDiameter())
                .over(method.choices());
    }

    public <T> T get(Setting<T> setting) {
        return settings.get(setting);
    }

    public MeshSource mesh() {
        return new MeshSource(get(SceneSettings.MESH), get(SceneSettings.MESH_UNIT));
    }

    public Scene withMesh(MeshSource value) {
        return with(SceneSettings.MESH, value.name()).with(SceneSettings.MESH_UNIT, value.unit());
    }

    public PatchRequest patch() {
        return patches.regions().get(0).patch();
    }

    public Scene withPatch(PatchRequest value) {
        return withPatches(PatchAtlas.of(value));
    }

    /** Returns the built-in or absolute names of textures, maps and patches. */
    public List<String> files() {
        return Stream.concat(
                        Stream.of(get(SceneSettings.ENVIRONMENT)),
                        perObject().stream().flatMap(Scene::filesOfObject))
                .toList();
    }

    private Stream<String> filesOfObject() {
        Stream<String> own = Stream.of(get(SceneSettings.TEXTURE), get(SceneSettings.ORIENTATION_MAP), patches.map());
        return Stream.concat(
                own, patches.regions().stream().map(region -> region.patch().patch()));
    }

    public Scene withPatches(PatchAtlas value) {
        return new Scene(settings, value, view, orientation, light, fillLights, method, objects, current);
    }

    /** Returns this scene with a user's patch, and a dark body for an animal's. */
    public Scene withOwnPatch(PatchRequest value) {
        Scene other = withPatch(value);
        return BodyTexture.isAnimal(get(SceneSettings.TEXTURE))
                ? other.with(SceneSettings.TEXTURE, BodyTexture.DARK)
                : other;
    }

    public Scene withView(Viewpoint value) {
        return new Scene(settings, patches, value, orientation, light, fillLights, method, objects, current);
    }

    public Scene withOrientation(Quaternionfc value) {
        return new Scene(settings, patches, view, value, light, fillLights, method, objects, current);
    }

    public Scene withLight(SceneLight value) {
        return new Scene(settings, patches, view, orientation, value, fillLights, method, objects, current);
    }

    public Scene withFillLights(List<SceneLight> value) {
        return new Scene(settings, patches, view, orientation, light, value, method, objects, current);
    }

    /** Returns all lights, the key light first. */
    public List<SceneLight> lights() {
        return Stream.concat(Stream.of(light), fillLights.stream()).toList();
    }

    /**
     * Returns an even number of scenes with the key light in directions around its own, with which automatic exposure compares that one; none
     * under an environment, which has light from all sides.
     */
    public List<Scene> lightsAround() {
        if (hasEnvironment()) {
            return List.of();
        }
        return light.around(METER_TILTS, METER_TILT).stream()
                .map(this::withLight)
                .toList();
    }

    /** Returns all that automatic exposure depends on and that the viewer measures again: material and weights, not light, view and method. */
    public List<Object> exposureInputs() {
        return perObject().stream()
                .<Object>map(one -> List.of(one.settings.only(SceneSettings.PARTS), one.weights(), one.patches))
                .toList();
    }

    /** Returns the standard deviation of a light's directions, radians; 0 with the thesis's preset. */
    public double deviation(SceneLight one) {
        return method.isThesis() ? 0 : one.deviation();
    }

    public Scene withMethod(SceneMethod value) {
        return new Scene(settings, patches, view, orientation, light, fillLights, value, objects, current);
    }

    public Choices weights() {
        return settings.only(SceneSettings.WEIGHTS);
    }

    public boolean hasBody() {
        return hasBody(settings);
    }

    private static boolean hasBody(Choices settings) {
        return settings.get(SceneSettings.TEXTURE_WEIGHT) > 0
                && (settings.get(SceneSettings.DIFFUSE) > 0 || settings.get(SceneSettings.AMBIENT) > 0);
    }

    public Scene withoutBody() {
        return with(SceneSettings.TEXTURE_WEIGHT, 0.0)
                .with(SceneSettings.DIFFUSE, 0.0)
                .with(SceneSettings.AMBIENT, 0.0);
    }

    public Placement placement() {
        return objects.get(current).placement();
    }

    /** Only the built-in snake has any. */
    public Scales effectiveScales() {
        return get(SceneSettings.MESH).equals("snake") ? get(SceneSettings.SCALES) : Scales.NONE;
    }

    /** Not with the thesis's preset, save for {@link SceneSettings#KEEPS_SURROUNDINGS}. */
    private boolean drawsSurroundings() {
        return !method.isThesis() || get(SceneSettings.KEEPS_SURROUNDINGS);
    }

    public Optional<SceneColor> ground() {
        return drawsSurroundings() ? get(SceneSettings.GROUND) : Optional.empty();
    }

    /** Radiance of the zenith, which gloss reflects, relative to white under the light. */
    public double sky() {
        return drawsSurroundings() ? get(SceneSettings.SKY) : 0;
    }

    /** Returns the color behind the mesh; black if the environment is seen there. */
    public SceneColor background() {
        return get(SceneSettings.BACKGROUND).orElse(new SceneColor(0));
    }

    public boolean showsEnvironment() {
        return hasEnvironment() && get(SceneSettings.BACKGROUND).isEmpty();
    }

    /** True if an environment lights the scene, in place of its lights. */
    public boolean hasEnvironment() {
        return !get(SceneSettings.ENVIRONMENT).equals(SceneSettings.NONE);
    }

    /** Share of ambient light; an environment is itself the light from all sides. */
    public double ambient() {
        return hasEnvironment() ? 0 : get(SceneSettings.AMBIENT);
    }

    public boolean hasShadows() {
        return drawsSurroundings() && get(SceneSettings.SHADOWS);
    }

    /** True if ambient light depends on the visible share of the sky. */
    public boolean occludesSky() {
        return sky() > 0 || ground().isPresent() || hasEnvironment();
    }

    /** Scalar with the thesis's preset and for methods not normalized to a mirror. */
    public Energy effectiveEnergy() {
        return method.isThesis() || !method.method().isNormalizedToMirror() ? Energy.SCALAR : get(SceneSettings.ENERGY);
    }

    /** Standard deviation, along either axis, of the slopes of relief finer than a pixel; 0 with the thesis's preset. */
    public double slopeDeviation() {
        return method.isThesis() ? 0 : Math.tan(get(SceneSettings.ROUGHNESS));
    }

    /** {@link #slopeDeviation} for color tables, which are averages over the slopes; else 0. */
    public double tabulatedSlopes() {
        return method.isTable() ? slopeDeviation() : 0;
    }

    /** Returns the display transform for an exposure factor, with the scene's or the preset's curve and primaries. */
    public DisplayTransform display(double factor) {
        Tone tone = settings.get(SceneSettings.TONE, Tone.of(method.isThesis()));
        return new DisplayTransform(
                factor, tone, settings.get(SceneSettings.PRIMARIES, Primaries.of(method.isThesis())));
    }

    public BodyAlpha bodyAlpha() {
        return settings.get(SceneSettings.BODY_ALPHA, method.isThesis() ? BodyAlpha.FRESNEL : BodyAlpha.LIGHT);
    }
}
