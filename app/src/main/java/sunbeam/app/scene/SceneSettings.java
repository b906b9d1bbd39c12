package sunbeam.app.scene;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import sunbeam.app.scene.environment.LightTree;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.Scales;
import sunbeam.precompute.color.Primaries;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Settings of scenes, except those of patches and methods. */
public final class SceneSettings {
    private static final String AUTOMATIC = "auto";
    public static final String NONE = "none";
    private static final String LIGHTS_RANGE = "auto, or a number from 1 to " + LightTree.MOST;
    private static final double LARGEST_EXPOSURE = 1e9;
    private static final double LARGEST_WEIGHT = 1e9;
    // Many turns, which a twisted model may add up; single precision does not represent more well.
    private static final double MOST_DEGREES = 1e6;
    // The model assumes small slopes; a slope turns a reflected direction by twice its angle.
    private static final double MOST_ROUGHNESS_DEGREES = 10;
    // Lights are drawn in parts as wide as the widest level of a color table.
    private static final double MOST_LIGHT_DEGREES = 15;

    public static final Setting<String> TITLE =
            new Setting<>("title", ValueKind.text("TITLE"), "For people.").withStandard("");

    public static final Setting<String> MESH = new Setting<>(
            "mesh",
            ValueKind.text("MESH"),
            "snake, plane, sphere, ellipsoid, cylinder, disc, or a file: OBJ, PLY, glTF.");

    public static final Setting<MeshSource.Unit> MESH_UNIT = new Setting<>(
                    "meshUnit",
                    ValueKind.word("UNIT", MeshSource.Unit.class),
                    "Unit of a mesh file: m, cm, mm, um or in (inches). glTF is always in m.")
            .withStandard(MeshSource.Unit.M);

    public static final Setting<String> TEXTURE = new Setting<>(
            "texture",
            ValueKind.text("TEXTURE"),
            "Colors of the body: elaphe, xenopeltis, dark, none, or an image file.");

    public static final Setting<Scales> SCALES = new Setting<>(
                    "scales",
                    ValueKind.word("KIND", Scales.class),
                    "Scales of mesh snake: smooth (15 rows, as of a sunbeam snake), keeled (21 rows, as of a rat snake) or none.")
            .withStandard(Scales.NONE);

    /** Radians, counterclockwise seen from outside. */
    public static final Setting<Double> ROTATE_PATCH = new Setting<>(
                    "rotatePatch",
                    ValueKind.angle(Math.toRadians(-MOST_DEGREES), Math.toRadians(MOST_DEGREES)),
                    "Rotation of the nanostructure in the tangent plane in degrees, counter-clockwise seen from outside.")
            .withStandard(0.0);

    /** Directions relative to the tangent. */
    public static final Setting<String> ORIENTATION_MAP = new Setting<>(
                    "orientationMap",
                    ValueKind.text("FILE"),
                    "Directions of the nanostructure's x axis, before its rotation: an image file on the mesh's texture"
                            + " coordinates whose red and green are x and y (a flow map), or none.")
            .withStandard(Body.NONE);

    /** Key of the object {@code patch}. */
    static final Setting<String> PATCH_MAP = new Setting<>(
            "map",
            ValueKind.text("FILE"),
            "An image file on the mesh's texture coordinates, each of whose colors has a patch.");

    /** Radians, of the slopes' standard deviation along either axis. */
    public static final Setting<Double> ROUGHNESS = new Setting<>(
                    "roughness",
                    ValueKind.angle(0, Math.toRadians(MOST_ROUGHNESS_DEGREES)),
                    "Standard deviation of the slopes of relief finer than a pixel, in degrees, 0 to 10; preset thesis has"
                            + " none.")
            .withStandard(0.0);

    public static final Setting<OptionalDouble> EXPOSURE = new Setting<>(
                    "exposure", exposure(), "Factor for the linear colors, or auto.")
            .withStandard(OptionalDouble.empty());

    /** Compressed by default, clipped with the thesis's preset. */
    public static final Setting<Tone> TONE = new Setting<>(
            "tone",
            ValueKind.word("CURVE", Tone.class),
            "Light brighter than the screen: compress (default) keeps its hue, clip limits each channel (thesis), gamma"
                    + " limits each channel and has an exponent of 1 / 2.5 (the thesis's program).");

    public static final String PRIMARIES_HELP =
            "Primaries of the picture: srgb (default), or cie-rgb shown as if it were sRGB (default with --preset thesis).";

    /** The default is sRGB, with the thesis's preset CIE RGB. */
    public static final Setting<Primaries> PRIMARIES =
            new Setting<>("primaries", ValueKind.word("RGB", Primaries.class), PRIMARIES_HELP);

    /** The default is luminance, with the thesis's preset Fresnel's reflectance. */
    public static final Setting<BodyAlpha> BODY_ALPHA = new Setting<>(
                    "bodyAlpha",
                    ValueKind.word("WHAT", BodyAlpha.class),
                    "Opacity of diffracted light over the body: light (default), its brightness relative to white; fresnel,"
                            + " the reflectance (the thesis's program; default with --preset thesis); draft, none: the"
                            + " unlit texture is added (algorithm 3.4 of the thesis's text 000).")
            .inFiles("alpha");

    public static final Setting<Double> DIFFRACTION = weight("diffraction", "Factor of the diffracted light.", 1);

    public static final Setting<Double> TEXTURE_WEIGHT = weight("texture", "Factor of the body's texture.", 1);

    public static final Setting<Double> DIFFUSE = weight("diffuse", "Share of Lambert's reflection on the body.", 1);

    public static final Setting<Double> AMBIENT = weight("ambient", "Share of ambient light.", 0);

    public static final Setting<SkinIndex> INDEX = new Setting<>(
                    "index",
                    ValueKind.text(
                            "N",
                            SkinIndex::parse,
                            SkinIndex::format,
                            "an index such as 1.56 or 0.97+6.5i, or a file (.csv)"),
                    "Refractive index of the skin: a number, n+ki for metals and coats of metal, or a CSV file in the"
                            + " form of refractiveindex.info, by wavelength.")
            .withStandard(SkinIndex.KERATIN);

    public static final Setting<Energy> ENERGY = new Setting<>(
                    "energy",
                    ValueKind.word("RULE", Energy.class),
                    "scalar (default): scalar theory, in which orders at grazing angles can send out more light than"
                            + " arrives. conserve: radiance divided by this excess; not with preset thesis.")
            .withStandard(Energy.SCALAR);

    public static final Setting<Optional<SceneColor>> GROUND = new Setting<>(
                    "ground",
                    colorOr(NONE),
                    "Color of the ground on which the mesh lies, or none; preset thesis has none.")
            .withStandard(Optional.empty());

    public static final Setting<Double> SKY = new Setting<>(
                    "sky",
                    ValueKind.number("FACTOR", 0, 100),
                    "Radiance of the sky that gloss reflects, relative to lit white; preset thesis has 0.")
            .withStandard(0.0);

    public static final Setting<String> ENVIRONMENT = new Setting<>(
                    "environment",
                    ValueKind.text("NAME"),
                    "Light from all directions, in place of the scene's lights: window, overcast, sun, sky, a Radiance file"
                            + " (.hdr), or none. Not with preset thesis.")
            .inFiles("file")
            .withStandard(NONE);

    /** Radians, counterclockwise from above. */
    public static final Setting<Double> ENVIRONMENT_ROTATION = new Setting<>(
                    "environmentRotation",
                    ValueKind.angle(Math.toRadians(-MOST_DEGREES), Math.toRadians(MOST_DEGREES)),
                    "Rotation of the environment about the vertical in degrees, counter-clockwise from above.")
            .inFiles("rotation")
            .withStandard(0.0);

    public static final Setting<Double> ENVIRONMENT_INTENSITY = new Setting<>(
                    "environmentIntensity", ValueKind.number("FACTOR", 0, 1e6), "Factor of the environment's radiance.")
            .inFiles("intensity")
            .withStandard(1.0);

    /** Lights that stand for the environment; empty if a tolerance decides. */
    public static final Setting<OptionalInt> ENVIRONMENT_LIGHTS = new Setting<>(
                    "environmentLights",
                    new ValueKind<>(
                            "N",
                            ValueKind.Form.NUMBER,
                            SceneSettings::parseLights,
                            value -> value,
                            value -> value.isEmpty() ? AUTOMATIC : value.getAsInt() + "",
                            LIGHTS_RANGE),
                    "Lights that stand for the environment by method table, 1 to 2048, or auto: as many as the tolerance needs.")
            .inFiles("lights")
            .withStandard(OptionalInt.empty());

    public static final Setting<Boolean> SHADOWS = new Setting<>(
                    "shadows",
                    ValueKind.flag(),
                    "The mesh casts shadows on itself and on the ground; preset thesis has none.")
            .withStandard(false);

    /** Whether surroundings are drawn also with the thesis's preset, to compare methods; no setting of files or options. */
    public static final Setting<Boolean> KEEPS_SURROUNDINGS =
            new Setting<>("keepsSurroundings", ValueKind.flag(), "").withStandard(false);

    /** Empty to show the environment. */
    public static final Setting<Optional<SceneColor>> BACKGROUND = new Setting<>(
                    "background",
                    colorOr("environment"),
                    "Color behind the mesh; exposure does not change it. Or environment, to see that.")
            .withStandard(Optional.of(new SceneColor(0)));

    /** Radians. */
    static final Setting<Double> FIELD_OF_VIEW = new Setting<>(
                    "fieldOfView",
                    ValueKind.angle(Viewpoint.NARROWEST, Viewpoint.WIDEST),
                    "Angle between the bottom and top of a picture of 4:3 or wider; narrower ones have the horizontal angle of 4:3.")
            .withStandard(Math.toRadians(30));

    public static final Setting<Double> INTENSITY =
            new Setting<>("intensity", ValueKind.number("FACTOR", 0, 1e6), "Factor of the light.").withStandard(1.0);

    /** Radians; see {@link SceneLight#deviation}. */
    public static final Setting<Double> ANGULAR_DIAMETER = new Setting<>(
                    "angularDiameter",
                    ValueKind.angle(0, Math.toRadians(MOST_LIGHT_DEGREES)),
                    "Diameter of the light as seen from the scene in degrees, 0 to 15; the sun has 0.53; preset thesis has none.")
            .withStandard(0.0);

    static final List<Setting<?>> WEIGHTS = List.of(DIFFRACTION, TEXTURE_WEIGHT, DIFFUSE, AMBIENT, BODY_ALPHA);

    static final List<Setting<?>> OF_ENVIRONMENT =
            List.of(ENVIRONMENT, ENVIRONMENT_ROTATION, ENVIRONMENT_INTENSITY, ENVIRONMENT_LIGHTS);

    /** Keys of the root, in the order in which they are written. */
    static final List<Setting<?>> OF_ROOT = List.of(
            TITLE,
            MESH,
            MESH_UNIT,
            TEXTURE,
            SCALES,
            ROTATE_PATCH,
            ORIENTATION_MAP,
            ROUGHNESS,
            EXPOSURE,
            TONE,
            PRIMARIES,
            INDEX,
            ENERGY,
            GROUND,
            SKY,
            SHADOWS,
            BACKGROUND);

    private static final List<Setting<?>> OF_SKIN = List.of(ROUGHNESS, INDEX, ENERGY);

    /** Keys of the root, or of each of several objects. */
    static final List<Setting<?>> OF_ROOT_OR_OBJECT =
            Setting.union(List.of(MESH, MESH_UNIT, TEXTURE, SCALES, ROTATE_PATCH, ORIENTATION_MAP), OF_SKIN);

    static final List<Setting<?>> OF_ROOT_ALONE = OF_ROOT.stream()
            .filter(setting -> !OF_ROOT_OR_OBJECT.contains(setting))
            .toList();

    static final List<Setting<?>> OF_OBJECT = Setting.union(OF_ROOT_OR_OBJECT, WEIGHTS);

    /** Settings of the shading pass: objects with equal ones, and equal patches, are shaded together. */
    static final List<Setting<?>> OF_LOOK = Setting.union(OF_SKIN, WEIGHTS);

    static final List<Setting<?>> OF_SCENE =
            Stream.of(OF_ROOT, OF_ENVIRONMENT, WEIGHTS).flatMap(List::stream).toList();

    static final List<Setting<?>> OF_RECORD =
            Stream.concat(OF_SCENE.stream(), Stream.of(KEEPS_SURROUNDINGS)).toList();

    /** Settings whose change requires loading. */
    static final List<Setting<?>> PARTS =
            Setting.union(List.of(MESH, MESH_UNIT, TEXTURE, SCALES, ORIENTATION_MAP, ENVIRONMENT), OF_SKIN);

    public static final List<Setting<?>> OVERRIDABLE = OF_SCENE.stream()
            .filter(setting -> !List.of(TITLE, BACKGROUND).contains(setting))
            .toList();

    private SceneSettings() {}

    static Choices standards(List<Setting<?>> settings) {
        Choices standard = Choices.none();
        for (Setting<?> setting : settings) {
            standard = standard.orStandard(setting);
        }
        return standard;
    }

    /** Names of built-in environments, and of none. */
    public static List<String> environments() {
        return Stream.concat(RadianceMap.builtIn().stream(), Stream.of(NONE)).toList();
    }

    private static ValueKind<Optional<SceneColor>> colorOr(String word) {
        return ValueKind.text(
                "#rrggbb",
                text -> text.strip().equals(word) ? Optional.empty() : Optional.of(SceneColor.parse(text)),
                color -> color.map(SceneColor::toString).orElse(word),
                word + " or #rrggbb");
    }

    private static Setting<Double> weight(String name, String help, double standard) {
        return new Setting<>(name + "Weight", ValueKind.number("W", 0, LARGEST_WEIGHT), help)
                .inFiles(name)
                .withStandard(standard);
    }

    private static ValueKind<OptionalDouble> exposure() {
        String range = "auto, or a number above 0 to " + Decimals.format(LARGEST_EXPOSURE);
        UnaryOperator<OptionalDouble> check = value -> {
            double factor = value.orElse(1);
            // Subnormal numbers have fewer digits.
            if (!(factor >= Double.MIN_NORMAL && factor <= LARGEST_EXPOSURE)) {
                throw new IllegalArgumentException(Decimals.format(factor) + " is out of range; give " + range);
            }
            return value;
        };
        return new ValueKind<>(
                "FACTOR",
                ValueKind.Form.NUMBER,
                SceneSettings::parseExposure,
                check,
                value -> value.isEmpty() ? AUTOMATIC : Decimals.format(value.getAsDouble()),
                range);
    }

    private static OptionalInt parseLights(String text) {
        OptionalDouble count = Decimals.parse(text);
        boolean isAutomatic = text.strip().equals(AUTOMATIC);
        boolean isCount = count.orElse(0) >= 1
                && count.orElse(0) <= LightTree.MOST
                && count.orElse(0) == Math.rint(count.orElse(0));
        if (!isAutomatic && !isCount) {
            throw new IllegalArgumentException(Text.quoted(text) + " is out of range; give " + LIGHTS_RANGE);
        }
        return isAutomatic ? OptionalInt.empty() : OptionalInt.of((int) count.getAsDouble());
    }

    private static OptionalDouble parseExposure(String text) {
        OptionalDouble factor = Decimals.parse(text);
        if (factor.isEmpty() && !text.strip().equals(AUTOMATIC)) {
            throw new IllegalArgumentException(Text.quoted(text) + " is neither auto nor a number above 0");
        }
        return factor;
    }

    /** Opacity of the diffracted light over the body (shaders/include/blend.glsl). */
    public enum BodyAlpha {
        /** Luminance relative to white. */
        LIGHT,
        /** Reflectance, as in the thesis's program. */
        FRESNEL,
        /** The unlit texture is added where |F| / |F(0)| > 1: everywhere but in the mirror direction (thesis algorithm 3.4). */
        DRAFT
    }
}
