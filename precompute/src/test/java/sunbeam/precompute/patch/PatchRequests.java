package sunbeam.precompute.patch;

import sunbeam.precompute.patch.PatchLoader.HeightCache;
import sunbeam.precompute.setting.ChoiceOrigin;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

final class PatchRequests {
    private static final ChoiceOrigin OPTION =
            ChoiceOrigin.of(ChoiceOrigin.Place.OPTION, setting -> "--" + setting.words("-"));

    private PatchRequests() {}

    /** A patch's name or file, and settings and words in turn; settings whose word is null are not given. */
    static PatchRequest of(Object patch, Object... settingsAndWords) {
        Choices choices = Choices.at(OPTION).parsed(PatchSettings.PATCH, patch.toString(), OPTION);
        for (int i = 0; i < settingsAndWords.length; i += 2) {
            String word = (String) settingsAndWords[i + 1];
            choices = word == null ? choices : choices.parsed((Setting<?>) settingsAndWords[i], word, OPTION);
        }
        return new PatchRequest(choices);
    }

    static Patch load(Object patch, Object... settingsAndWords) {
        return load(of(patch, settingsAndWords));
    }

    static Patch load(PatchRequest request) {
        return PatchLoader.load(request, HeightCache.NONE);
    }
}
