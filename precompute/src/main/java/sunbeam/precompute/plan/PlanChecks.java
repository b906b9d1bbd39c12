package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.util.Locale;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.TaylorExpansion;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/** Refuses what cannot be right, with the numbers that say why. */
final class PlanChecks {
    // A Gaussian of deviation s sampled at a pitch p has replicas of its spectrum one period 1 / p away. The first adds
    // exp(-2 pi^2 s^2 / p^2), 6e-5 at s = 0.7 p or a coherence length of 2.8 p, where the spectrum itself is 1. What
    // that
    // does to a coherent power, PlanWarnings say.
    private static final double FEWEST_SAMPLES = 2.8;

    // Metres: the first order of a period of two samples is then 3 degrees from the mirror direction at 550 nm.
    private static final double COARSEST_PITCH = 5e-6;

    private PlanChecks() {}

    /** A window that the patch has too few samples for. */
    static void check(CoherenceWindow window, HeightMap map) {
        double pitch = coarsestPitch(map);
        double coherenceLength = window.coherenceLength();
        if (coherenceLength < FEWEST_SAMPLES * pitch) {
            throw SettingException.of(
                    COHERENCE_LENGTH,
                    coherenceLength,
                    String.format(
                            Locale.ROOT,
                            "is less than %.1f samples of the patch, which are %s apart; %s",
                            FEWEST_SAMPLES,
                            Lengths.format(pitch),
                            pitch > COARSEST_PITCH
                                    ? "no structure that diffracts light shows in samples so far apart: check the scan's"
                                            + " size and its unit"
                                    : "give " + Lengths.format(FEWEST_SAMPLES * pitch) + " or more"));
        }
    }

    /** The larger distance of samples, of axes that have more than one; metres. */
    static double coarsestPitch(HeightMap map) {
        return Math.max(map.columns() > 1 ? map.pitchX() : 0, map.rows() > 1 ? map.pitchY() : 0);
    }

    /** A radius that was planned must not be cut short; one that was given is small enough already. */
    static void checkRadius(int radius, CoherenceWindow window, double sigmaBins) {
        if (radius > Neighborhood.MAXIMUM_RADIUS) {
            throw SettingException.of(
                    COHERENCE_LENGTH,
                    window.coherenceLength(),
                    String.format(
                            Locale.ROOT,
                            "has a spectrum %.1f DFT bins wide, which takes a neighborhood of radius %d, but at most %d"
                                    + " can be summed; leave out ",
                            sigmaBins,
                            radius,
                            Neighborhood.MAXIMUM_RADIUS),
                    WAVELENGTH_STEP,
                    " (the plan then interpolates a grid), give a larger ",
                    COHERENCE_LENGTH,
                    ", or fix a smaller ",
                    RADIUS);
        }
    }

    /** Taylor's terms reach e^phase before they cancel, and float32 has seven digits. */
    static TaylorExpansion accurate(TaylorExpansion expansion, double tolerance) {
        double reachable = Math.ulp(1f) * expansion.largestTerm(expansion.maximumPhase());
        if (reachable > tolerance) {
            throw taylor(expansion, String.format(Locale.ROOT, "reaches only %.1g in float32", reachable));
        }
        return expansion;
    }

    /** A number of terms that was given may be inaccurate, but not overflow, squared, as a power. */
    static TaylorExpansion withinFloatRange(TaylorExpansion expansion) {
        if (Math.pow(expansion.largestTerm(expansion.maximumPhase()), 2) > Float.MAX_VALUE) {
            throw taylor(
                    expansion,
                    String.format(Locale.ROOT, "with %d terms leaves the range of float32", expansion.terms()));
        }
        return expansion;
    }

    private static SettingException taylor(TaylorExpansion expansion, String problem) {
        String relief = String.format(
                Locale.ROOT,
                " at this relief (%s, phases up to %.1f); use lowrank or chebyshev",
                Lengths.format(2 * expansion.scale().halfRange()),
                expansion.maximumPhase());
        return SettingException.of(EXPANSION, ExpansionKind.TAYLOR, problem + relief);
    }
}
