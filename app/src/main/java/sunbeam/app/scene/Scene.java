package sunbeam.app.scene;

import static sunbeam.app.scene.SceneSettings.EXPOSURE;
import static sunbeam.app.scene.SceneSettings.INDEX;
import static sunbeam.app.scene.SceneSettings.INTENSITY;
import static sunbeam.app.scene.SceneSettings.MESH;
import static sunbeam.app.scene.SceneSettings.MESH_UNIT;
import static sunbeam.app.scene.SceneSettings.ORIENTATION_MAP;
import static sunbeam.app.scene.SceneSettings.PRIMARIES;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.app.scene.SceneSettings.ROUGHNESS;
import static sunbeam.app.scene.SceneSettings.SCALES;
import static sunbeam.app.scene.SceneSettings.TEXTURE;
import static sunbeam.app.scene.SceneSettings.TONE;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.stream.Stream;
import jrtr.scene.LightUniforms;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.texture.BodyTextures;
import sunbeam.app.scene.texture.Scales;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Primaries;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.setting.Choices;

/**
 * All that determines a picture but its size. Files are named absolutely, so that a scene means the same everywhere in
 * the process; {@link SceneReader} and {@link SceneWriter} turn them into names relative to the scene's folder.
 *
 * @param title for people; may be empty
 * @param mesh a built-in mesh or an absolute file
 * @param patches the nanostructure, or several and where they are
 * @param view from where
 * @param orientation turns the mesh about the centre of its bounding sphere; unit length
 * @param light the key light
 * @param fillLights further lights, which cast no shadows; at most {@link #MOST_FILL_LIGHTS}
 * @param texture the body's colors: a built-in texture, {@code "none"} or an absolute image file
 * @param scales of mesh snake
 * @param method how diffraction is computed
 * @param rotatePatch turns the nanostructure in the tangent plane, radians, counter-clockwise seen from outside
 * @param orientationMap where the nanostructure's x points before that: {@code "none"} or an absolute image file
 * @param roughness standard deviation of the slopes of relief finer than a pixel, as an angle, radians
 * @param exposure factor of the linear picture, above 0; empty to choose it from the picture
 * @param tone what becomes of highlights; empty for the method's own
 * @param primaries that colors are written in; empty for the method's own
 * @param blend weights of diffracted light and body
 * @param index of the skin
 * @param surroundings of the mesh
 * @param background behind the mesh, not exposed
 */
public record Scene(
        String title,
        MeshSource mesh,
        PatchAtlas patches,
        Viewpoint view,
        Quaternionfc orientation,
        SceneLight light,
        List<SceneLight> fillLights,
        String texture,
        Scales scales,
        SceneMethod method,
        double rotatePatch,
        String orientationMap,
        double roughness,
        OptionalDouble exposure,
        Optional<Tone> tone,
        Optional<Primaries> primaries,
        Blend blend,
        SkinIndex index,
        Surroundings surroundings,
        SceneColor background) {
    /** With the key light as many as shaders take. */
    public static final int MOST_FILL_LIGHTS = LightUniforms.MOST - 1;

    /** Copies; rejects rotations and exposures that are none, and too many lights. */
    public Scene {
        if (!(Math.abs(orientation.lengthSquared() - 1) < 1e-3f)) {
            throw new IllegalArgumentException("orientation " + orientation + " has not the length 1");
        }
        orientation = new Quaternionf(orientation);
        fillLights = List.copyOf(fillLights);
        if (fillLights.size() > MOST_FILL_LIGHTS) {
            throw new IllegalArgumentException(
                    fillLights.size() + " fill lights are too many; give at most " + MOST_FILL_LIGHTS);
        }
        ROTATE_PATCH.kind().check(rotatePatch);
        ROUGHNESS.kind().check(roughness);
        EXPOSURE.kind().check(exposure);
    }

    /** The same with what was chosen of {@link SceneSettings} and {@link Methods#SETTINGS} above it. */
    public Scene with(Choices chosen) {
        return changed(draft -> {
            // The unit is of one file.
            MeshSource before = chosen.has(MESH) ? MeshSource.of(chosen.get(MESH)) : mesh;
            draft.mesh = new MeshSource(before.name(), chosen.get(MESH_UNIT, before.unit()));
            draft.light = new SceneLight(light.towards(), chosen.get(INTENSITY, light.intensity()));
            draft.texture = chosen.get(TEXTURE, texture);
            draft.scales = chosen.get(SCALES, scales);
            draft.method = method.with(chosen.only(Methods.SETTINGS));
            draft.rotatePatch = chosen.get(ROTATE_PATCH, rotatePatch);
            draft.orientationMap = chosen.get(ORIENTATION_MAP, orientationMap);
            draft.roughness = chosen.get(ROUGHNESS, roughness);
            draft.exposure = chosen.get(EXPOSURE, exposure);
            draft.tone = chosen.find(TONE).or(() -> tone);
            draft.primaries = chosen.find(PRIMARIES).or(() -> primaries);
            draft.index = chosen.get(INDEX, index);
            draft.surroundings = Surroundings.of(chosen.over(surroundings.choices()));
            draft.blend = Blend.of(chosen.over(blend.choices()));
        });
    }

    /** What {@link #with} may change, as it is. */
    public Choices choices() {
        return Choices.none()
                .with(MESH, mesh.name())
                .with(MESH_UNIT, mesh.unit())
                .with(TEXTURE, texture)
                .with(SCALES, scales)
                .with(ROTATE_PATCH, rotatePatch)
                .with(ROUGHNESS, roughness)
                .with(EXPOSURE, exposure)
                .with(TONE, display(1).tone())
                .with(PRIMARIES, display(1).primaries())
                .with(INDEX, index)
                .with(INTENSITY, light.intensity())
                .over(surroundings.choices())
                .over(blend.choices())
                .over(method.choices());
    }

    /** The same with another mesh. */
    public Scene withMesh(MeshSource value) {
        return changed(draft -> draft.mesh = value);
    }

    /** The nanostructure, the first of several. */
    public PatchRequest patch() {
        return patches.regions().get(0).patch();
    }

    /** The same with another patch, everywhere. */
    public Scene withPatch(PatchRequest value) {
        return withPatches(PatchAtlas.of(value));
    }

    /** Names of the pictures that it is made of, among them some that are no files. */
    public List<String> files() {
        Stream<String> heights =
                patches.regions().stream().map(region -> region.patch().patch());
        return Stream.concat(Stream.of(texture, orientationMap, patches.map()), heights)
                .toList();
    }

    /** The same with other patches. */
    public Scene withPatches(PatchAtlas value) {
        return changed(draft -> draft.patches = value);
    }

    /** The same with a user's patch: the body of another animal would not suit it. */
    public Scene withOwnPatch(PatchRequest value) {
        Scene other = withPatch(value);
        return BodyTextures.isAnimal(texture) ? other.withTexture(BodyTextures.DARK) : other;
    }

    /** The same from elsewhere. */
    public Scene withView(Viewpoint value) {
        return changed(draft -> draft.view = value);
    }

    /** The same with the mesh turned differently. */
    public Scene withOrientation(Quaternionfc value) {
        return changed(draft -> draft.orientation = value);
    }

    /** The same under another light. */
    public Scene withLight(SceneLight value) {
        return changed(draft -> draft.light = value);
    }

    /** The same under other fill lights. */
    public Scene withFillLights(List<SceneLight> value) {
        return changed(draft -> draft.fillLights = value);
    }

    /** How many lights it has. */
    int lights() {
        return 1 + fillLights.size();
    }

    /**
     * The same under one of its lights alone. Light adds up: the sum of these pictures is the scene's. Fill lights cast no
     * shadows.
     *
     * @param number 0 for the key light
     */
    Scene underLight(int number) {
        if (lights() == 1) {
            return this;
        }
        return changed(draft -> {
            draft.fillLights = List.of();
            if (number > 0) {
                draft.light = fillLights.get(number - 1);
                draft.surroundings = surroundings.withoutShadows();
            }
        });
    }

    /** The same with another texture. */
    public Scene withTexture(String value) {
        return changed(draft -> draft.texture = value);
    }

    /** The same with another method. */
    public Scene withMethod(SceneMethod value) {
        return changed(draft -> draft.method = value);
    }

    /** The same with other weights. */
    public Scene withBlend(Blend value) {
        return changed(draft -> draft.blend = value);
    }

    /** The same of another material. */
    public Scene withIndex(SkinIndex value) {
        return changed(draft -> draft.index = value);
    }

    /** Whether another scene differs only in light, camera, weights and the like, which need no loading. */
    public boolean sharesParts(Scene other) {
        return mesh.equals(other.mesh)
                && patches.equals(other.patches)
                && texture.equals(other.texture)
                && worn().equals(other.worn())
                && orientationMap.equals(other.orientationMap)
                && method.method().equals(other.method.method())
                && tabulatedSlopes() == other.tabulatedSlopes()
                && index.sharesSpectrum(other.index);
    }

    /** The same with another's parts, so that both share them. */
    public Scene withPartsOf(Scene other) {
        return changed(draft -> {
            draft.mesh = other.mesh;
            draft.patches = other.patches;
            draft.texture = other.texture;
            draft.scales = other.scales;
            draft.orientationMap = other.orientationMap;
            draft.method = other.method;
            draft.roughness = other.roughness;
            draft.index = index.sharesSpectrum(other.index) ? index : other.index;
        });
    }

    /** Scales that are drawn: those of the built-in snake. */
    Scales worn() {
        return mesh.name().equals("snake") ? scales : Scales.NONE;
    }

    /** What is drawn around the mesh: nothing by the thesis's preset. */
    Surroundings around() {
        return method.isThesis() ? Surroundings.NONE : surroundings;
    }

    /** Standard deviation along either axis of the slopes of relief finer than a pixel; 0 by the thesis's preset. */
    double slopeDeviation() {
        return method.isThesis() ? 0 : Math.tan(roughness);
    }

    /** That deviation where it is part of what is loaded: color tables are averages over the slopes. */
    double tabulatedSlopes() {
        return method.type().equals(TableMethod.TYPE) ? slopeDeviation() : 0;
    }

    /** How a screen shows the picture: as the method's preset does unless the scene says otherwise. */
    public DisplayTransform display(double factor) {
        return new DisplayTransform(
                factor, tone.orElse(Tone.of(method.isThesis())), primaries.orElse(Primaries.of(method.isThesis())));
    }

    /** What hides the body, as the method's preset has it unless the scene says otherwise. */
    BodyAlpha bodyAlpha() {
        return blend.alpha().orElse(method.isThesis() ? BodyAlpha.FRESNEL : BodyAlpha.LIGHT);
    }

    private Scene changed(Consumer<Draft> change) {
        Draft draft = new Draft(this);
        change.accept(draft);
        return draft.scene();
    }

    /** A scene's parts while some of them change. */
    private static final class Draft {
        private String title;
        private MeshSource mesh;
        private PatchAtlas patches;
        private Viewpoint view;
        private Quaternionfc orientation;
        private SceneLight light;
        private List<SceneLight> fillLights;
        private String texture;
        private Scales scales;
        private SceneMethod method;
        private double rotatePatch;
        private String orientationMap;
        private double roughness;
        private OptionalDouble exposure;
        private Optional<Tone> tone;
        private Optional<Primaries> primaries;
        private Blend blend;
        private SkinIndex index;
        private Surroundings surroundings;
        private SceneColor background;

        private Draft(Scene scene) {
            title = scene.title;
            mesh = scene.mesh;
            patches = scene.patches;
            view = scene.view;
            orientation = scene.orientation;
            light = scene.light;
            fillLights = scene.fillLights;
            texture = scene.texture;
            scales = scene.scales;
            method = scene.method;
            rotatePatch = scene.rotatePatch;
            orientationMap = scene.orientationMap;
            roughness = scene.roughness;
            exposure = scene.exposure;
            tone = scene.tone;
            primaries = scene.primaries;
            blend = scene.blend;
            index = scene.index;
            surroundings = scene.surroundings;
            background = scene.background;
        }

        private Scene scene() {
            return new Scene(
                    title,
                    mesh,
                    patches,
                    view,
                    orientation,
                    light,
                    fillLights,
                    texture,
                    scales,
                    method,
                    rotatePatch,
                    orientationMap,
                    roughness,
                    exposure,
                    tone,
                    primaries,
                    blend,
                    index,
                    surroundings,
                    background);
        }
    }
}
