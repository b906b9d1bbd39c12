package sunbeam.precompute.plan;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Plan of the sums that method {@code full} takes: expansion, DFT bins, and sampling of the windowed spectrum.
 *
 * @param tolerance promised relative error; empty for the thesis's choices, which promise none
 * @param range directions that can occur
 * @param bandX bins along x to compute and store
 * @param origin sample under the window's maximum
 */
public record SpectrumPlan(
        Optional<Double> tolerance,
        VisibleRange range,
        Expansion expansion,
        Band bandX,
        Band bandY,
        CoherenceWindow window,
        WindowOrigin origin,
        Average average,
        Sampling sampling) {
    /** Margin of bins for shorter windows, in their sigma_f. */
    private static final double SHORT_WINDOW_REACH = 4;

    /**
     * Transforms a surface's heights.
     *
     * @param progress receives the number of terms finished by each transform
     */
    public FourierTable fourierTable(HeightLevels heights, IntConsumer progress) {
        return FourierTable.of(heights, expansion, bandX, bandY, progress);
    }

    /** Returns this plan with the bins, too, that are within reach of visible directions under a shorter window. */
    public SpectrumPlan widened(double width, double height, CoherenceWindow shortest) {
        double margin = SHORT_WINDOW_REACH * shortest.sigmaFrequency();
        return new SpectrumPlan(
                tolerance,
                range,
                expansion,
                bandX.widened((int) Math.ceil(margin * width)),
                bandY.widened((int) Math.ceil(margin * height)),
                window,
                origin,
                average,
                sampling);
    }

    /** Returns |(u, v)| up to which a direction sees the specular peak, which outshines diffracted light. */
    public double specularReach() {
        return window.specularReach(CieTable.MAXIMUM_WAVELENGTH);
    }

    /** Returns a text that determines the tables of one patch; different numbers have different texts. */
    public String key() {
        return String.join(
                "|",
                expansion.key(),
                bandX.toString(),
                bandY.toString(),
                range.toString(),
                window.toString(),
                origin.toString(),
                average.toString(),
                sampling.toString());
    }

    /** Returns one line about accuracy, window and sampling, for users who do not know the method. */
    public String summary() {
        return Text.format(
                "%s, coherence length %s, %s average, %s",
                promise(), Lengths.format(window.coherenceLength()), ValueKind.name(average), sampling.summary(range));
    }

    private String promise() {
        return tolerance
                .map(error -> Text.format(
                        "colors planned to %s %% (95 %% of directions to %s %%)", percent(error), percent(3 * error)))
                .orElse("as in the thesis");
    }

    /** Formats a share as a percentage, without the percent sign. */
    public static String percent(double share) {
        return new BigDecimal(100 * share)
                .round(new MathContext(3))
                .stripTrailingZeros()
                .toPlainString();
    }

    private String terms() {
        return expansion.terms() + " " + ValueKind.name(expansion.kind()) + " terms";
    }

    /** Such as "699 x 699 DFT bins". */
    String bins() {
        return bandX.count() + " x " + bandY.count() + " DFT bins";
    }

    /** Returns a line per reason that breaks the tolerance: the user's choices, and {@link #shortfalls}. */
    public List<Sentence> warnings() {
        return PlanChecks.warnings(this);
    }

    /** Returns a line per reason why the tolerance cannot be promised with any settings, and the accuracy that is reached. */
    public List<Sentence> shortfalls() {
        return PlanChecks.shortfalls(this);
    }

    /** Returns one line about memory on the graphics card. */
    public String cost(int patchRows) {
        return "textures of at most "
                + MemoryNeed.inWords(MemoryNeed.of(this, patchRows).textureBytes());
    }

    /** Returns a line per choice, with its reason. */
    public List<String> reasons() {
        List<String> lines = new ArrayList<>();
        lines.add("sizes: " + terms() + ", " + sampling.summary(range) + ", " + bins());
        lines.add(Text.format(
                "directions: u %.3f..%.3f, v %.3f..%.3f, |w| %.3f..%.3f can occur; nothing else is computed",
                range.minimumU(),
                range.maximumU(),
                range.minimumV(),
                range.maximumV(),
                range.minimumW(),
                range.maximumW()));
        lines.add(Text.format(
                "expansion: phases k |w| h of %.2f to %.2f rad take %s; error %.1e",
                expansion.minimumPhase(), expansion.maximumPhase(), terms(), expansion.error()));
        lines.add(Text.format(
                "window: coherence length %s, its spectrum has a deviation of %.4g cycles per meter, centered on the %s",
                Lengths.format(window.coherenceLength()),
                window.sigmaFrequency(),
                origin == WindowOrigin.CORNER ? "corner" : "patch's center"));
        lines.add("bins: " + bins() + " reach every visible frequency at 380 nm and the window's width beyond");
        return lines;
    }
}
