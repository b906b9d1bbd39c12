package sunbeam.precompute.plan;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.setting.Excess;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Plan of the sums that method {@code full} takes; it promises a tolerance, except for the thesis's choices. */
public record SpectrumPlan(
        Optional<Double> tolerance,
        VisibleRange range,
        Expansion expansion,
        Band bandX,
        Band bandY,
        GaussianArea area,
        Sampling sampling) {
    // In units in the last place: a fifth of the largest, as measured.
    private static final double TYPICAL_ROUNDING = 0.1;
    // Error at the 95th percentile of power per radian of the largest phase; measured.
    private static final double PHASE_ROUNDING = 3e-7;
    /** Margin of bins for shorter windows, in their sigma_f. */
    private static final double SHORT_WINDOW_REACH = 4;

    /** Transforms heights; the consumer receives the number of terms finished by each transform. */
    public FourierTable fourierTable(HeightMap heights, IntConsumer progress) {
        return FourierTable.of(heights, expansion, bandX, bandY, progress);
    }

    /** Returns this plan with the bins, too, that are within reach of visible directions under a shorter window. */
    public SpectrumPlan widened(HeightMap map, CoherenceWindow shortest) {
        double margin = SHORT_WINDOW_REACH * shortest.sigmaFrequency();
        return new SpectrumPlan(
                tolerance,
                range,
                expansion,
                bandX.widened((int) Math.ceil(margin * map.width())),
                bandY.widened((int) Math.ceil(margin * map.height())),
                area,
                sampling);
    }

    public CoherenceWindow window() {
        return area.window();
    }

    List<ArrayLayout> layouts(MethodUse use) {
        return sampling.serving(use).layouts(this, use);
    }

    /** Returns the shader's tables, with layers computed on demand; the Fourier table may have fewer terms than this plan. */
    public ShaderTables tables(FourierTable table, MethodUse use, CieTable cie) {
        return sampling.serving(use).tables(this, table, use, cie);
    }

    /** Returns a text that determines the tables of one patch; different numbers have different texts. */
    public String key() {
        return expansion.key() + "|" + bandX + "|" + bandY + "|" + range + "|" + area + "|" + sampling;
    }

    public String summary() {
        String promise = tolerance
                .map(error -> Text.format(
                        "colors planned to %s %% (95 %% of directions to %s %%)", percent(error), percent(3 * error)))
                .orElse("as in the thesis");
        return Text.format(
                "%s, coherence length %s, %s average, %s",
                promise,
                Lengths.format(window().coherenceLength()),
                ValueKind.name(area.average()),
                sampling.summary(range));
    }

    /** Returns the work of the slowest pixel in words: a deeper relief needs more terms and more wavelengths. */
    public String steps() {
        return Text.format("up to %,d steps a pixel", sampling.loopSteps(this));
    }

    public static String percent(double share) {
        return new BigDecimal(100 * share)
                .round(new MathContext(3))
                .stripTrailingZeros()
                .toPlainString();
    }

    private String terms() {
        return expansion.terms() + " " + ValueKind.name(expansion.kind()) + " terms";
    }

    private String bins() {
        return bandX.count() + " x " + bandY.count() + " DFT bins";
    }

    /** Returns the reasons that break the tolerance: the user's choices and {@link #shortfalls}; none for the thesis's. */
    public List<Sentence> warnings() {
        List<Sentence> lines = shortfalls();
        tolerance.ifPresent(promised -> {
            if (expansion.error() > promised) {
                lines.add(Sentence.of(
                        Text.format(
                                "%d %s terms leave an error of %.1g, more than the tolerance %s; give more ",
                                expansion.terms(), ValueKind.name(expansion.kind()), expansion.error(), promised),
                        MethodSettings.TERMS,
                        ", or leave it out"));
            }
            if (sampling instanceof Sampling.BinSampling bins && !bins.planned()) {
                lines.add(Sentence.of(
                        "equal steps of the wavelength keep no tolerance; leave out ", MethodSettings.WAVELENGTH_STEP));
            }
        });
        return lines;
    }

    /** Returns a sentence per reason why no settings keep the tolerance, with the accuracy that is reached. */
    public List<Sentence> shortfalls() {
        List<Sentence> lines = new ArrayList<>();
        tolerance.ifPresent(promised -> {
            double percentile = Math.max(ErrorBudget.FLOAT32_PERCENTILE, PHASE_ROUNDING * expansion.maximumPhase());
            if (promised < ErrorBudget.FINEST_CERTAIN || percentile > 3 * promised) {
                lines.add(Sentence.of(Text.format(
                        "float32 keeps the tolerance %s in the median, but leaves errors of up to %s at the 95th"
                                + " percentile of power, more than three times the tolerance; method reference is more"
                                + " exact",
                        Decimals.format(promised),
                        Decimals.format(Double.parseDouble(Decimals.rounded(percentile, 2))))));
            }
            double reachable = reachable();
            if (reachable > promised) {
                lines.add(Sentence.of(Text.format(
                        "colors on flanks of orders far from the specular direction reach only %.0e, not the tolerance"
                                + " %s: the spectrum of a coherence length of %s is narrower than float32"
                                + " resolves; give a shorter one, or single wavelengths ('reflectance'), which have"
                                + " double precision",
                        reachable, Decimals.format(promised), Lengths.format(window().coherenceLength()))));
            }
        });
        return lines;
    }

    /**
     * Returns the error of colors on flanks of orders: float32 resolves a frequency to half a unit in the last place, and three deviations
     * from an order's middle the power changes by six times the relative shift.
     */
    private double reachable() {
        double farthest = range.longestUv() / CieTable.MINIMUM_WAVELENGTH;
        return 6 * TYPICAL_ROUNDING * Math.ulp(1f) * farthest / window().sigmaFrequency();
    }

    public String cost(int patchRows) {
        return "textures of at most "
                + MemoryNeed.inWords(MemoryNeed.of(this, patchRows).textureBytes());
    }

    public List<String> reasons() {
        return List.of(
                "sizes: " + terms() + ", " + sampling.summary(range) + ", " + bins(),
                Text.format(
                        "directions: u %.3f..%.3f, v %.3f..%.3f, |w| %.3f..%.3f can occur; nothing else is computed",
                        range.minimumU(),
                        range.maximumU(),
                        range.minimumV(),
                        range.maximumV(),
                        range.minimumW(),
                        range.maximumW()),
                Text.format(
                        "expansion: phases k |w| h of %.2f to %.2f rad take %s; error %.1e",
                        expansion.minimumPhase(), expansion.maximumPhase(), terms(), expansion.error()),
                Text.format(
                        "window: coherence length %s, its spectrum has a deviation of %.4g cycles per meter, centered on the %s",
                        Lengths.format(window().coherenceLength()),
                        window().sigmaFrequency(),
                        area.origin() == WindowOrigin.CORNER ? "corner" : "patch's center"),
                "bins: " + bins() + " reach every visible frequency at 380 nm and the window's width beyond");
    }

    /** Refuses this plan beyond the limits of memory and of a shader's loop steps. */
    Optional<SettingException> refusal(int rows, long heapLimit, long mostSteps) {
        return excess(rows, heapLimit, mostSteps)
                .map(excess -> SettingException.of(
                                MethodSettings.COHERENCE_LENGTH,
                                window().coherenceLength(),
                                excess.words()
                                        + "; method table, for the ensemble average, and method reference, for lists, take less; else crop the"
                                        + " patch, or give a coarser ",
                                MethodSettings.TOLERANCE,
                                ", fewer ",
                                MethodSettings.TERMS,
                                ", a smaller ",
                                MethodSettings.RADIUS,
                                ", a larger ",
                                MethodSettings.WAVELENGTH_STEP,
                                " or another ",
                                MethodSettings.COHERENCE_LENGTH)
                        .because(excess));
    }

    /** Returns which limit is exceeded, in words as the end of a sentence that begins with "coherence length 65 um". */
    private Optional<Excess> excess(int rows, long heapLimit, long mostSteps) {
        Optional<Excess> memory = Arrays.stream(MethodUse.values())
                .flatMap(use -> MemoryNeed.of(this, use, rows).excess(heapLimit).stream())
                .findFirst();
        long steps = sampling.loopSteps(this);
        if (memory.isEmpty() && steps > mostSteps) {
            return Optional.of(Excess.ofDriver(Text.format(
                    "takes %,d steps a pixel with %s, more than %,d, beyond which graphics drivers may end loops",
                    steps, sampling.summary(range), mostSteps)));
        }
        return memory.map(excess -> new Excess(
                Text.format("and %s in %d terms %s", bins(), expansion.terms(), excess.words()), excess.heapBytes()));
    }
}
