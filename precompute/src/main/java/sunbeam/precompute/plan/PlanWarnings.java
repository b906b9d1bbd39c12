package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.TERMS;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.units.Lengths;

/** What breaks the tolerance that is promised: parts that a user fixed, or a tolerance at the edge of float32. */
final class PlanWarnings {
    // With five, the replicas of the window's spectrum meet at exp(-(5 pi / 4)^2 / 2) = 4e-4 of an amplitude.
    private static final double FEWEST_SAMPLES = 5;

    // For the single row of a patch much longer than the window; with three samples in it the first replica alone
    // counts.
    private static final int MOST_REPLICAS = 1000;

    // Units in the last place: a fifth of the bound, as measured for colors of orders at 65 um.
    private static final double TYPICAL_ROUNDING = 0.1;

    private final Plan plan;
    private final HeightMap map;

    PlanWarnings(Plan plan, HeightMap map) {
        this.plan = plan;
        this.map = map;
    }

    /** One each; none for what was planned for a tolerance well within float32, nor for the thesis's choices, which promise nothing. */
    List<Sentence> lines() {
        List<Sentence> lines = new ArrayList<>();
        plan.accuracy().tolerance().ifPresent(tolerance -> {
            lines.addAll(shortfalls());
            checkTerms(tolerance, lines);
            lines.addAll(plan.sampling().warnings(plan, tolerance, map));
        });
        return lines;
    }

    /** What cannot be promised whatever is chosen. */
    List<Sentence> shortfalls() {
        List<Sentence> lines = new ArrayList<>();
        plan.accuracy().tolerance().ifPresent(tolerance -> {
            checkFloat32(tolerance, lines);
            checkFrequencies(tolerance, lines);
            checkScale(tolerance, lines);
        });
        return lines;
    }

    private static void checkFloat32(double tolerance, List<Sentence> lines) {
        if (tolerance < ErrorBudget.FINEST_CERTAIN) {
            lines.add(Sentence.of(format(
                    "float32 keeps the tolerance %s in the median, but leaves errors of up to %s at the 95th percentile of"
                            + " power, of which three times the tolerance is promised; method reference goes further",
                    shown(tolerance), shown(ErrorBudget.FLOAT32_PERCENTILE))));
        }
    }

    private void checkTerms(double tolerance, List<Sentence> lines) {
        Expansion expansion = plan.expansion();
        double error = expansion.error();
        if (error > tolerance) {
            lines.add(Sentence.of(
                    format(
                            "%d %s terms leave an error of %.1g, more than the tolerance %s; give more ",
                            expansion.terms(), expansion.kind().label(), error, tolerance),
                    TERMS,
                    ", or leave it out"));
        }
    }

    /** Orders of a wide window are narrow; where one is, float32 tells to half a unit in the last place of its frequency. */
    private void checkFrequencies(double tolerance, List<Sentence> lines) {
        double farthest = plan.range().longestUv() / CieTable.MINIMUM_WAVELENGTH;
        double sigma = plan.window().sigmaFrequency();
        // Three deviations from an order's middle, where it has a ten thousandth of its power, that changes by six
        // times the
        // relative shift.
        double reachable = 6 * TYPICAL_ROUNDING * Math.ulp(1f) * farthest / sigma;
        if (reachable > tolerance) {
            lines.add(Sentence.of(format(
                    "colors on flanks of orders far from the specular direction reach only %.0e, not the tolerance %s: the spectrum of a coherence"
                            + " length of %s is narrower than float32 tells frequencies apart; give a shorter one, or"
                            + " a wavelength each ('reflectance'), whose frequencies are found in double precision",
                    reachable, shown(tolerance), Lengths.format(plan.window().coherenceLength()))));
        }
    }

    /** The sum over a coarse window's samples, by which a coherent power is divided, is not its integral, which bins know. */
    private void checkScale(double tolerance, List<Sentence> lines) {
        // Its square is between the powers.
        double error = Math.pow(sumByIntegral(map.pitchX()) * sumByIntegral(map.pitchY()), 2) - 1;
        if (plan.average() == Average.COHERENT && error > tolerance) {
            double pitch = Math.max(map.pitchX(), map.pitchY());
            lines.add(Sentence.of(format(
                    "coherent power and its colors are %.1e too large, more than the tolerance %s: a coherence length of %s"
                            + " has too few samples, which are %s apart; give %s or more, a finer scan, or evaluate"
                            + " directions by method reference",
                    error,
                    shown(tolerance),
                    Lengths.format(plan.window().coherenceLength()),
                    Lengths.format(pitch),
                    Lengths.format(FEWEST_SAMPLES * pitch))));
        }
    }

    /**
     * The sum over a Gaussian's samples relative to its integral, along one axis. By Poisson's sum this is
     * 1 + 2 sum_k exp(-2 pi^2 k^2 s^2 / pitch^2): replicas of its spectrum lie one period of the sampling apart.
     */
    private double sumByIntegral(double pitch) {
        double sum = 1;
        for (int k = 1; k <= MOST_REPLICAS; k++) {
            sum += 2 * Math.exp(-2 * Math.pow(Math.PI * k * plan.window().sigmaMetres() / pitch, 2));
        }
        return sum;
    }

    /** As people write it: 1e-5, not 1.0E-5. */
    private static String shown(double value) {
        return Double.toString(value).replaceFirst("\\.0(E|$)", "$1").replace('E', 'e');
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
