package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.util.Optional;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Limit of the coherence length by the size of a scan. A longer window resolves orders that are 1 / size apart in frequency, which come
 * from the scan's repetition and not from the surface. A patch that is no period of its surface gets at most its shorter side; one whose
 * repetition is only assumed keeps the chosen length, with a warning. The thesis's preset repeats any patch.
 *
 * @param limiting side of the scan that limits the coherence length: width or height
 */
public record ScanLimit(Choices choices, Optional<Sentence> line, Optional<String> limiting) {
    // Shortest coherence length in meters, and slack for the rounding of a side.
    private static final double SHORTEST = 100e-9;
    private static final double SLACK = 1 + 1e-9;

    public static ScanLimit of(Choices choices, Patch patch) {
        double chosen = choices.get(COHERENCE_LENGTH);
        double side = patch.shorterSide();
        if (!choices.get(Methods.METHOD).has(COHERENCE_LENGTH)
                || Preset.isThesis(choices)
                || patch.repetition() == Patch.Repetition.PERIODIC
                || chosen <= side * SLACK) {
            return new ScanLimit(choices, Optional.empty(), Optional.empty());
        }
        if (patch.repetition() == Patch.Repetition.ASSUMED) {
            Sentence assumed = Sentence.of(
                    Text.format(
                            "the surface is repeated every %s, which a coherence length of %s resolves as sharp orders that the scan cannot confirm; state whether it is ",
                            Lengths.format(side), Lengths.format(chosen)),
                    PatchSettings.PERIODIC);
            return new ScanLimit(choices, Optional.of(assumed), Optional.empty());
        }
        String limiting = patch.heights().width() <= side * SLACK ? "width" : "height";
        if (side < SHORTEST) {
            throw new InputException(Text.format(
                    "%s: its %s of %s is less than the shortest coherence length, %s; use a larger scan, a single row or column, or state that it repeats (%s)",
                    patch.name(),
                    limiting,
                    Lengths.format(side),
                    Lengths.format(SHORTEST),
                    choices.origin(PatchSettings.PATCH).name(PatchSettings.PERIODIC)));
        }
        double ratio = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH / side;
        Sentence shortened = Sentence.of(
                Text.format(
                        "coherence length %s (the scan's %s%s; %s %s): orders are %s times as broad as in sunlight; use a larger scan, or, if this one is a period of the surface, ",
                        Lengths.rounded(side, 4),
                        limiting,
                        patch.heights().heights().length < patch.scan().heights().length ? " less its overlap" : "",
                        Lengths.format(chosen),
                        choices.has(COHERENCE_LENGTH) ? "asked" : "in sunlight",
                        Text.format(ratio < 10 ? "%.1f" : "%.0f", ratio)),
                PatchSettings.PERIODIC);
        Choices limited = choices.with(COHERENCE_LENGTH, side, choices.origin(COHERENCE_LENGTH));
        return new ScanLimit(limited, Optional.of(shortened), Optional.of(limiting));
    }
}
