package sunbeam.app.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import jrtr.scene.Light;
import jrtr.scene.View.Camera;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import sunbeam.app.scene.SceneSettings.BodyAlpha;
import sunbeam.app.scene.SceneSettings.SkinIndex;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.texture.Body.Scales;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Primaries;
import sunbeam.precompute.color.DisplayTransform.Tone;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.PatchLoader.PatchRequest;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * All that determines a picture except its size. File names are absolute.
 *
 * @param settings values or defaults of all {@link SceneSettings} except those of patch, view and light
 * @param orientation rotation of the mesh about the center of its bounding sphere; unit length
 * @param fillLights further lights, which cast no shadows; at most {@link #MOST_FILL_LIGHTS}
 */
public record Scene(
        Choices settings,
        PatchAtlas patches,
        Viewpoint view,
        Quaternionfc orientation,
        SceneLight light,
        List<SceneLight> fillLights,
        SceneMethod method) {
    /** The shaders' limit of lights, less the key light. */
    public static final int MOST_FILL_LIGHTS = Light.MOST - 1;

    private static final Choices STANDARD = standard();

    public Scene {
        orientation = new Quaternionf(orientation);
        fillLights = List.copyOf(fillLights);
        settings = settings.only(SceneSettings.OF_RECORD).over(STANDARD);
    }

    private static Choices standard() {
        Choices standard = Choices.none();
        for (Setting<?> setting : SceneSettings.OF_RECORD) {
            standard = standard.orStandard(setting);
        }
        return standard;
    }

    /** Returns this scene with values of {@link SceneSettings} and {@link Methods#SETTINGS} in place of its own. */
    public Scene with(Choices chosen) {
        Choices inherited = chosen.has(SceneSettings.MESH) ? settings.without(SceneSettings.MESH_UNIT) : settings;
        double intensity = chosen.get(SceneSettings.INTENSITY, light.intensity());
        double diameter = chosen.get(SceneSettings.ANGULAR_DIAMETER, light.angularDiameter());
        SceneLight newLight = new SceneLight(light.towards(), intensity, diameter);
        SceneMethod newMethod = method.with(chosen.only(Methods.SETTINGS));
        return new Scene(chosen.over(inherited), patches, view, orientation, newLight, fillLights, newMethod);
    }

    public <T> Scene with(Setting<T> setting, T value) {
        return new Scene(settings.with(setting, value), patches, view, orientation, light, fillLights, method);
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

    /** Returns the built-in or absolute names of texture, maps and patches. */
    public List<String> files() {
        Stream<String> own = Stream.of(get(SceneSettings.TEXTURE), get(SceneSettings.ORIENTATION_MAP), patches.map());
        return Stream.concat(
                        own,
                        patches.regions().stream().map(region -> region.patch().patch()))
                .toList();
    }

    public Scene withPatches(PatchAtlas value) {
        return new Scene(settings, value, view, orientation, light, fillLights, method);
    }

    /** Returns this scene with a user's patch, and a dark body for an animal's. */
    public Scene withOwnPatch(PatchRequest value) {
        Scene other = withPatch(value);
        return BodyTexture.isAnimal(get(SceneSettings.TEXTURE))
                ? other.with(SceneSettings.TEXTURE, BodyTexture.DARK)
                : other;
    }

    public Scene withView(Viewpoint value) {
        return new Scene(settings, patches, value, orientation, light, fillLights, method);
    }

    public Scene withOrientation(Quaternionfc value) {
        return new Scene(settings, patches, view, value, light, fillLights, method);
    }

    public Scene withLight(SceneLight value) {
        return new Scene(settings, patches, view, orientation, value, fillLights, method);
    }

    public Scene withFillLights(List<SceneLight> value) {
        return new Scene(settings, patches, view, orientation, light, value, method);
    }

    /** Returns all lights, the key light first. */
    public List<SceneLight> lights() {
        return Stream.concat(Stream.of(light), fillLights.stream()).toList();
    }

    /** Returns the standard deviation of a light's directions, radians; 0 with the thesis's preset. */
    public double deviation(SceneLight one) {
        return method.isThesis() ? 0 : one.deviation();
    }

    public Scene withMethod(SceneMethod value) {
        return new Scene(settings, patches, view, orientation, light, fillLights, value);
    }

    public Choices weights() {
        return settings.only(SceneSettings.WEIGHTS);
    }

    public boolean hasBody() {
        return get(SceneSettings.TEXTURE_WEIGHT) > 0
                && (get(SceneSettings.DIFFUSE) > 0 || get(SceneSettings.AMBIENT) > 0);
    }

    public Scene withoutBody() {
        return with(SceneSettings.TEXTURE_WEIGHT, 0.0)
                .with(SceneSettings.DIFFUSE, 0.0)
                .with(SceneSettings.AMBIENT, 0.0);
    }

    /** True if another scene needs no other meshes, textures or tables. */
    public boolean sharesParts(Scene other) {
        return mesh().equals(other.mesh())
                && patches.equals(other.patches)
                && sharesBody(other)
                && method.method().equals(other.method.method())
                && tabulatedSlopes() == other.tabulatedSlopes()
                && sharesReflectance(other);
    }

    /** True if tables of both have the same factors: constant indices differ only in the divisor of conserved energy. */
    public boolean sharesReflectance(Scene other) {
        SkinIndex index = get(SceneSettings.INDEX);
        SkinIndex otherIndex = other.get(SceneSettings.INDEX);
        boolean areConstant = !index.isByWavelength() && !otherIndex.isByWavelength();
        return effectiveEnergy() == other.effectiveEnergy()
                && (index.equals(otherIndex) || (effectiveEnergy() == Energy.SCALAR && areConstant));
    }

    public boolean sharesBody(Scene other) {
        return get(SceneSettings.TEXTURE).equals(other.get(SceneSettings.TEXTURE))
                && effectiveScales() == other.effectiveScales()
                && get(SceneSettings.ORIENTATION_MAP).equals(other.get(SceneSettings.ORIENTATION_MAP));
    }

    public Scene withPartsOf(Scene other) {
        Choices parts = other.settings.only(SceneSettings.PARTS);
        Choices shared = sharesReflectance(other) ? parts.without(SceneSettings.INDEX) : parts;
        return new Scene(shared.over(settings), other.patches, view, orientation, light, fillLights, other.method);
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

    public boolean hasShadows() {
        return drawsSurroundings() && get(SceneSettings.SHADOWS);
    }

    /** True if ambient light depends on the visible share of the sky. */
    public boolean occludesSky() {
        return sky() > 0 || ground().isPresent();
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
        return method.type().equals(TableMethod.TYPE) ? slopeDeviation() : 0;
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

    /** Camera (meters, world space) and field of view, radians, of pictures of 4:3 or wider; narrower ones have the width of 4:3. */
    public record Viewpoint(Camera camera, double verticalFieldOfView) {
        /** Width over height below which a picture shows more above and below. */
        public static final double LEAST_ASPECT = 4.0 / 3;

        /** Radians; single precision does not resolve less. */
        public static final double NARROWEST = Math.toRadians(0.001);

        /** Radians; wider pictures are mostly distortion. */
        public static final double WIDEST = Math.toRadians(170);

        public double halfHeight(int width, int height) {
            return Math.tan(verticalFieldOfView / 2) * Math.max(1, LEAST_ASPECT * height / width);
        }
    }

    /** Motion of an animated scene about the vertical (z), counterclockwise from above. */
    public enum Motion {
        /** Light and camera stay. */
        TURNTABLE,
        /** Mesh and camera stay. */
        LIGHT_SWEEP;

        public Scene at(Scene scene, double radians) {
            if (this == TURNTABLE) {
                Quaternionf turn = new Quaternionf().rotationZ((float) radians);
                return scene.withOrientation(turn.mul(scene.orientation()).normalize());
            }
            Vector3f towards = new Vector3f(scene.light().towards()).rotateZ((float) radians);
            return scene.withLight(scene.light().pointing(towards));
        }
    }
}
