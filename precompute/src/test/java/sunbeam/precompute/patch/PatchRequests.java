package sunbeam.precompute.patch;

import java.util.List;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.OptionWords;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.Setting;

/** Patches asked for as a command line does. */
final class PatchRequests {
    private static final Origin OPTION = OptionWords.INSTANCE;

    private PatchRequests() {}

    /** Null stands for an option that was not given. */
    static PatchRequest parse(
            String patch, String width, String height, String maxHeight, String channel, String level) {
        List<Setting<?>> settings = List.of(
                PatchSettings.PATCH,
                PatchSettings.WIDTH,
                PatchSettings.HEIGHT,
                PatchSettings.MAX_HEIGHT,
                PatchSettings.CHANNEL,
                PatchSettings.LEVEL);
        String[] words = {patch, width, height, maxHeight, channel, level};
        Choices choices = Choices.at(OPTION);
        for (int i = 0; i < words.length; i++) {
            choices = words[i] == null ? choices : choices.parsed(settings.get(i), words[i], OPTION);
        }
        return new PatchRequest(choices);
    }

    /** The same request with one more choice. */
    static PatchRequest with(PatchRequest request, Setting<?> setting, String word) {
        return new PatchRequest(request.choices().parsed(setting, word, OPTION));
    }

    static PatchRequest of(String patch) {
        return parse(patch, null, null, null, null, null);
    }
}
