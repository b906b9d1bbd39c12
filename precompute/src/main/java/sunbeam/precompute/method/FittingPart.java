package sunbeam.precompute.method;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.SettingException;

/**
 * The part of a scan that can be drawn where the whole is too large: planned, not guessed.
 *
 * @param parts how many times narrower and lower than the scan it is
 * @param crop in the scan
 */
public record FittingPart(int parts, Crop crop) {
    // Each half as wide and high as the one before.
    private static final int TRIALS = 4;

    /**
     * The largest in the scan's middle, of those with halved sides; empty where none of four is small enough.
     *
     * @param plan plans a part, and throws a {@link SettingException} where that takes too much
     */
    public static Optional<FittingPart> of(Patch patch, Consumer<Patch> plan) {
        for (int trial = 1, parts = 2; trial <= TRIALS; trial++, parts *= 2) {
            double share = 0.5 - 0.5 / parts;
            double width = patch.scan().width();
            double height = patch.scan().height();
            Crop crop = new Crop(share * width, (1 - share) * width, share * height, (1 - share) * height);
            try {
                plan.accept(patch.part(crop));
                return Optional.of(new FittingPart(parts, crop));
            } catch (SettingException stillTooMuch) {
                // A smaller part may do.
            } catch (IllegalArgumentException noSamples) {
                return Optional.empty();
            }
        }
        return Optional.empty();
    }

    /** The end of a sentence that says what was too large. */
    public Sentence sentence(Patch patch) {
        String size =
                String.format(Locale.ROOT, "; a part of 1/%d of its width and height can be drawn as it is (", parts);
        return Sentence.of(size, PatchSettings.CROP, " " + patch.inFile(crop) + ")");
    }
}
