package sunbeam.precompute.patch;

import java.util.function.Supplier;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Choices of a patch; raw: files without a descriptor are prepared as in the thesis (mean subtracted, repeated). */
public record PatchRequest(Choices choices, boolean raw) {
    public PatchRequest {
        choices = choices.only(PatchSettings.ALL);
    }

    public PatchRequest(Choices choices) {
        this(choices, false);
    }

    public PatchRequest raw(boolean thesis) {
        return new PatchRequest(choices, thesis);
    }

    public static PatchRequest of(String patch) {
        return new PatchRequest(Choices.none().with(PatchSettings.PATCH, patch));
    }

    public String patch() {
        return choices.get(PatchSettings.PATCH);
    }

    /** Runs an action whose exceptions name the origin of a setting or are an {@link InputException} about the patch. */
    <T> T located(Supplier<T> action) {
        try {
            return choices.located(action);
        } catch (SettingException wrong) {
            if (wrong.about().equals(PatchSettings.PATCH) || !choices.has(wrong.about())) {
                throw new InputException(wrong.getMessage(), wrong);
            }
            throw wrong;
        }
    }
}
