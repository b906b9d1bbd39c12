package sunbeam.app.cli.render;

import static sunbeam.app.scene.SceneSettings.INDEX;
import static sunbeam.app.scene.SceneSettings.SCALES;
import static sunbeam.app.scene.SceneSettings.TEXTURE;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.patch.PatchSettings.PATCH;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.ILLUMINANT;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.SkinIndex;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.Scales;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Applies command-line options that override a scene's settings; those of objects apply to each. */
public final class SceneOverrides {
    public static final List<Setting<?>> SETTINGS =
            Setting.union(SceneSettings.OVERRIDABLE, PatchSettings.ALL, Methods.SETTINGS);

    /** Texts of the help about defaults of settings that a scene may leave out. */
    public static final Map<Setting<?>, String> STANDARDS = Map.of(
            METHOD,
            "the scene's, " + SceneMethod.STANDARD + " where it names none",
            TOLERANCE,
            Text.format(
                    "the scene's; where it names none %s with table, %s otherwise",
                    Decimals.format(SceneMethod.TABLE_TOLERANCE),
                    TOLERANCE.writtenStandard().orElseThrow()),
            AVERAGE,
            "the scene's, ensemble where it names none");

    private SceneOverrides() {}

    /** Names of the built-in scenes, which help texts list as {@code ${COMPLETION-CANDIDATES}}. */
    public static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return Scenes.builtIn().iterator();
        }
    }

    /** Returns the scene with these choices in place of its own; throws a {@code SettingException} for contradictions. */
    public static Scene apply(Scene scene, Choices asked) {
        // The thesis's preset means method full, unless another method with that preset is chosen.
        boolean chooses = Preset.isThesis(asked)
                && !asked.has(METHOD)
                && !scene.method().type().has(PRESET);
        Choices given = chooses ? asked.with(METHOD, FullMethod.TYPE) : asked;
        checkAverage(scene, given);
        Choices located = withAbsoluteIndex(given);
        located = withAbsoluteName(located, SceneSettings.MESH, BuiltInMeshes.names());
        located = withAbsoluteName(located, TEXTURE, BodyTexture.names());
        located = withAbsoluteName(located, ILLUMINANT, Illuminant.NAMES);
        located = withAbsoluteName(located, SceneSettings.ORIENTATION_MAP, List.of(Body.NONE));
        located = withAbsoluteName(located, SceneSettings.ENVIRONMENT, SceneSettings.environments());
        Choices own = located;
        Scene applied = scene.each(object -> object.with(own));
        if (given.get(SCALES, Scales.NONE) != Scales.NONE
                && applied.perObject().stream().allMatch(object -> object.effectiveScales() == Scales.NONE)) {
            throw given.complaint(SCALES, "is for mesh snake; leave it out");
        }
        Choices ofPatch = withAbsoluteName(given, PATCH, BuiltInPatches.names());
        return applied.each(object -> patch(object, ofPatch));
    }

    /**
     * Refuses a chosen method without the ensemble average if the scene has this average, unless another average is chosen too. Method gem,
     * told by its lack of a tolerance, is not refused: averages do not apply to its formula.
     */
    private static void checkAverage(Scene scene, Choices given) {
        boolean lost = given.has(METHOD)
                && !given.get(METHOD).has(AVERAGE)
                && scene.method().type().has(AVERAGE)
                && scene.method().get(AVERAGE) == Average.ENSEMBLE;
        if (lost && given.get(METHOD).has(TOLERANCE) && !given.has(AVERAGE)) {
            throw given.complaint(
                    METHOD, "has no ensemble average, which the scene asks for; add ", AVERAGE, " coherent");
        }
    }

    private static Scene patch(Scene scene, Choices given) {
        Choices ofPatch = given.only(PatchSettings.ALL);
        if (given.has(PATCH)) {
            PatchRequest patch = new PatchRequest(ofPatch);
            boolean own = !given.has(TEXTURE) && !BuiltInPatches.names().contains(given.get(PATCH));
            return own ? scene.withOwnPatch(patch) : scene.withPatch(patch);
        }
        if (!ofPatch.chosen().isEmpty()) {
            throw given.complaint(ofPatch.chosen().get(0), "needs ", PATCH);
        }
        return scene;
    }

    /** Returns the choices with a file's name made absolute, as scenes store it; names of built-in things stay. */
    private static Choices withAbsoluteName(Choices given, Setting<String> setting, List<String> builtIn) {
        boolean isFile = given.has(setting) && !builtIn.contains(given.get(setting));
        return isFile ? given.with(setting, absolute(given.get(setting)), given.origin(setting)) : given;
    }

    private static Choices withAbsoluteIndex(Choices given) {
        boolean isFile = given.has(INDEX) && given.get(INDEX).isByWavelength();
        return isFile ? given.with(INDEX, SkinIndex.of(absolute(given.get(INDEX).file())), given.origin(INDEX)) : given;
    }

    private static String absolute(String file) {
        return Path.of(file).toAbsolutePath().normalize().toString();
    }
}
