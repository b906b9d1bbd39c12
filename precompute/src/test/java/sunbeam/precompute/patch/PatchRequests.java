package sunbeam.precompute.patch;

import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.OptionWords;
import sunbeam.precompute.setting.Origin;

/** Patches asked for as a command line does. */
final class PatchRequests {
    private static final Origin OPTION = OptionWords.INSTANCE;

    private PatchRequests() {}

    /** Null stands for an option that was not given. */
    static PatchRequest parse(
            String patch, String width, String height, String maxHeight, String channel, String level) {
        String[] words = {patch, width, height, maxHeight, channel, level};
        Choices choices = Choices.at(OPTION);
        for (int i = 0; i < words.length; i++) {
            choices = words[i] == null ? choices : choices.parsed(PatchSettings.ALL.get(i), words[i], OPTION);
        }
        return new PatchRequest(choices);
    }

    static PatchRequest of(String patch) {
        return parse(patch, null, null, null, null, null);
    }
}
