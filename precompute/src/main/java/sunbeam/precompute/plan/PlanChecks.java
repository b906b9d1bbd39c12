package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.TaylorExpansion;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.Kinds;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** What is refused of a plan, and what is said of one that cannot promise its tolerance, with the numbers that say why. */
final class PlanChecks {
    // Mesa's software renderer ends all loops of a pixel after 65,535 steps, without a word (shaders/include/loops.glsl
    // finds out). On graphics cards a pixel that takes more would take milliseconds.
    static final long MOST_LOOP_STEPS = 60_000;

    // A Gaussian of deviation s sampled at a pitch p has replicas of its spectrum one period 1 / p away. The first adds
    // exp(-2 pi^2 s^2 / p^2), 3e-9 at s = p, to the sum over its samples, by which a coherent power is divided.
    private static final double FEWEST_SAMPLES = 4;

    // Metres: the first order of a period of two samples is then 3 degrees from the mirror direction at 550 nm.
    private static final double COARSEST_PITCH = 5e-6;

    // Units in the last place: a fifth of the bound, as measured for colors of orders at 65 um.
    private static final double TYPICAL_ROUNDING = 0.1;

    // Error at the 95th percentile of power by radian of the largest phase, which float32 rounds: as measured for
    // grains and
    // terraces of 20 um on 5 nm of roughness.
    private static final double PHASE_ROUNDING = 3e-7;

    private PlanChecks() {}

    /** Refuses a window that the patch has too few samples for. */
    static void requireSamples(CoherenceWindow window, HeightMap map) {
        double pitch = Math.max(map.columns() > 1 ? map.pitchX() : 0, map.rows() > 1 ? map.pitchY() : 0);
        double coherenceLength = window.coherenceLength();
        if (coherenceLength < FEWEST_SAMPLES * pitch) {
            throw SettingException.of(
                    COHERENCE_LENGTH,
                    coherenceLength,
                    Text.format(
                            "is less than %.0f samples of the patch, which are %s apart; %s",
                            FEWEST_SAMPLES,
                            Lengths.format(pitch),
                            pitch > COARSEST_PITCH
                                    ? "no structure that diffracts light shows in samples so far apart: check the scan's"
                                            + " size and its unit"
                                    : "give " + Lengths.format(FEWEST_SAMPLES * pitch) + " or more"));
        }
    }

    /** Taylor's terms reach e^phase before they cancel, and float32 has seven digits. */
    static TaylorExpansion accurate(TaylorExpansion expansion, double tolerance) {
        double reachable = Math.ulp(1f) * expansion.largestTerm(expansion.maximumPhase());
        if (reachable > tolerance) {
            throw taylor(expansion, Text.format("reaches only %.1g in float32", reachable));
        }
        return expansion;
    }

    /** A number of terms that was given may be inaccurate, but not overflow, squared, as a power. */
    static TaylorExpansion withinFloatRange(TaylorExpansion expansion) {
        if (Math.pow(expansion.largestTerm(expansion.maximumPhase()), 2) > Float.MAX_VALUE) {
            throw taylor(expansion, Text.format("with %d terms leaves the range of float32", expansion.terms()));
        }
        return expansion;
    }

    private static SettingException taylor(TaylorExpansion expansion, String problem) {
        String relief = Text.format(
                " at this relief (%s, phases up to %.1f); use lowrank",
                Lengths.format(2 * expansion.scale().halfRange()), expansion.maximumPhase());
        return SettingException.of(EXPANSION, ExpansionKind.TAYLOR, problem + relief);
    }

    static SettingException tooLarge(Plan plan, int rows, long heapLimit, long mostSteps) {
        return SettingException.of(
                COHERENCE_LENGTH,
                plan.window().coherenceLength(),
                excess(plan, rows, heapLimit, mostSteps).orElseThrow()
                        + "; method table, for the ensemble average, and method reference, for lists, take less; else crop the"
                        + " patch, or give a coarser ",
                TOLERANCE,
                ", fewer ",
                TERMS,
                ", a smaller ",
                RADIUS,
                ", a larger ",
                WAVELENGTH_STEP,
                " or another ",
                COHERENCE_LENGTH);
    }

    /**
     * What a plan takes too much of, continuing "coherence length 65 um ..."; nothing where it fits.
     *
     * @param rows of the patch
     * @param heapLimit the most that Java's heap may take, bytes
     * @param mostSteps that loops may take for a pixel
     */
    static Optional<String> excess(Plan plan, int rows, long heapLimit, long mostSteps) {
        Optional<String> memory = MemoryNeed.of(plan, rows).excess(heapLimit);
        long steps = plan.sampling().loopSteps(plan);
        if (memory.isEmpty() && steps > mostSteps) {
            return Optional.of(Text.format(
                    "takes %,d steps a pixel with %s, more than %,d, beyond which graphics drivers may end loops",
                    steps, plan.sampling().summary(plan.range()), mostSteps));
        }
        return memory.map(excess -> Text.format(
                "and %s in %d terms %s", plan.bins(), plan.expansion().terms(), excess));
    }

    /** What breaks the tolerance, one sentence each: what a user fixed, and shortfalls. Nothing for the thesis's choices. */
    static List<Sentence> warnings(Plan plan) {
        List<Sentence> lines = shortfalls(plan);
        Expansion expansion = plan.expansion();
        plan.tolerance().ifPresent(tolerance -> {
            if (expansion.error() > tolerance) {
                lines.add(Sentence.of(
                        Text.format(
                                "%d %s terms leave an error of %.1g, more than the tolerance %s; give more ",
                                expansion.terms(), Kinds.name(expansion.kind()), expansion.error(), tolerance),
                        TERMS,
                        ", or leave it out"));
            }
            if (plan.sampling() instanceof BinSampling bins && !bins.planned()) {
                lines.add(Sentence.of(
                        "equal steps of the wavelength, which were asked for, promise no tolerance; leave out ",
                        WAVELENGTH_STEP));
            }
        });
        return lines;
    }

    /** What cannot be promised whatever is chosen, and what is reached. */
    static List<Sentence> shortfalls(Plan plan) {
        List<Sentence> lines = new ArrayList<>();
        plan.tolerance().ifPresent(tolerance -> {
            double percentile = Math.max(
                    ErrorBudget.FLOAT32_PERCENTILE,
                    PHASE_ROUNDING * plan.expansion().maximumPhase());
            if (tolerance < ErrorBudget.FINEST_CERTAIN || percentile > 3 * tolerance) {
                lines.add(Sentence.of(Text.format(
                        "float32 keeps the tolerance %s in the median, but leaves errors of up to %s at the 95th"
                                + " percentile of power, of which three times the tolerance is promised; method"
                                + " reference goes further",
                        Decimals.format(tolerance),
                        Decimals.format(Double.parseDouble(Decimals.rounded(percentile, 2))))));
            }
            double reachable = reachable(plan);
            if (reachable > tolerance) {
                lines.add(Sentence.of(Text.format(
                        "colors on flanks of orders far from the specular direction reach only %.0e, not the tolerance"
                                + " %s: the spectrum of a coherence length of %s is narrower than float32 tells"
                                + " frequencies apart; give a shorter one, or a wavelength each ('reflectance'), whose"
                                + " frequencies are found in double precision",
                        reachable,
                        Decimals.format(tolerance),
                        Lengths.format(plan.window().coherenceLength()))));
            }
        });
        return lines;
    }

    /**
     * Error of colors on flanks of orders. Orders of a wide window are narrow, and float32 tells where one is to half a unit in
     * the last place of its frequency. Three deviations from an order's middle, where it has a ten thousandth of its power, that
     * changes by six times the relative shift.
     */
    private static double reachable(Plan plan) {
        double farthest = plan.range().longestUv() / CieTable.MINIMUM_WAVELENGTH;
        return 6 * TYPICAL_ROUNDING * Math.ulp(1f) * farthest / plan.window().sigmaFrequency();
    }
}
