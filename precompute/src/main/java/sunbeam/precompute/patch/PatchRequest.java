package sunbeam.precompute.patch;

import java.util.Optional;
import java.util.function.Supplier;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/**
 * A patch that somebody asks for.
 *
 * @param choices of {@link PatchSettings}
 * @param raw whether files given directly are taken as the thesis takes them, less their mean and repeated, where nothing
 *     else is chosen
 */
public record PatchRequest(Choices choices, boolean raw) {
    /** Keeps what is about patches. */
    public PatchRequest {
        choices = choices.only(PatchSettings.ALL);
    }

    /** What somebody chose. */
    public PatchRequest(Choices choices) {
        this(choices, false);
    }

    /** The same for the thesis's preset, or not. */
    public PatchRequest raw(boolean thesis) {
        return new PatchRequest(choices, thesis);
    }

    /** A surface and nothing else, which the program asks for. */
    public static PatchRequest of(String patch) {
        return new PatchRequest(Choices.none().with(PatchSettings.PATCH, patch));
    }

    /** What the surface is called: a built-in name, a descriptor (*.json) or an image. */
    public String patch() {
        return choices.get(PatchSettings.PATCH);
    }

    /** What was chosen of a setting. */
    public <T> Optional<T> find(Setting<T> setting) {
        return choices.find(setting);
    }

    /** Whether nothing but the surface was chosen. */
    public boolean isNameOnly() {
        return choices.without(PatchSettings.PATCH).chosen().isEmpty();
    }

    /**
     * The result of an action, whose complaints about settings name the place where they were chosen. A surface that cannot
     * be used, or of which something must be said that was not, is no wrong choice but a wrong file.
     *
     * @throws PatchException for these
     */
    <T> T located(Supplier<T> action) {
        try {
            return choices.located(action);
        } catch (SettingException wrong) {
            if (wrong.about().equals(PatchSettings.PATCH) || !choices.has(wrong.about())) {
                throw new PatchException(wrong.getMessage(), wrong);
            }
            throw wrong;
        }
    }
}
