package sunbeam.app.viewer.components;

import java.util.Locale;
import java.util.Map;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices.Origin;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;

/** Origin of choices made by the window's controls; names a setting by its control's caption. */
public enum ControlOrigin implements Origin {
    INSTANCE;

    // Captions of settings whose key, split into words, would be too long or too vague.
    private static final Map<Setting<?>, String> CAPTIONS = Map.of(
            MethodSettings.COHERENCE_LENGTH, "Coherence",
            MethodSettings.SPACING, "Lines",
            PatchSettings.MAX_HEIGHT, "Height of full scale",
            SceneSettings.ROTATE_PATCH, "Rotation",
            SceneSettings.DIFFRACTION, "Diffraction",
            SceneSettings.INTENSITY, "Light",
            SceneSettings.TEXTURE_WEIGHT, "Texture's weight",
            SceneSettings.INDEX, "Refractive index");

    @Override
    public Place place() {
        return Place.CONTROL;
    }

    @Override
    public String name(Setting<?> setting) {
        String words = setting.words(" ");
        return CAPTIONS.getOrDefault(setting, words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1));
    }

    /** Returns a control's tooltip: effect, unit and limits of the setting, then {@code more}, a text about the control. */
    public String tip(Setting<?> setting, String more) {
        ValueKind<?> kind = setting.kind();
        String unit = kind.form() == ValueKind.Form.QUANTITY ? "With its unit" : "Without unit";
        String values = kind.form() == ValueKind.Form.TEXT ? "No unit." : unit + ", " + kind.range() + ".";
        return wrapped(String.join(" ", setting.help().in(this), values, more));
    }

    static String wrapped(String text) {
        return "<html><body style='width: 260px'>"
                + text.replace("&", "&amp;").replace("<", "&lt;").strip();
    }
}
