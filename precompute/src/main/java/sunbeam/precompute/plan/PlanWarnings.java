package sunbeam.precompute.plan;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.units.Lengths;

/** What breaks the tolerance that is promised: parts that a user fixed, or a tolerance at the edge of float32. */
final class PlanWarnings {
    private final Plan plan;
    private final HeightMap map;

    PlanWarnings(Plan plan, HeightMap map) {
        this.plan = plan;
        this.map = map;
    }

    /** One line each; none for what was planned for a tolerance well within float32, nor for the thesis's choices, which promise nothing. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        if (Double.isNaN(plan.tolerance())) {
            return lines;
        }
        checkFloat32(lines);
        checkTerms(lines);
        if (plan.sampling() instanceof Sampling.Bins bins) {
            checkRadius(bins.neighbourhood().radius(), lines);
            checkWavelengths(bins.wavelengths().count(), lines);
        }
        return lines;
    }

    private void checkFloat32(List<String> lines) {
        if (plan.tolerance() < Tolerances.FINEST_CERTAIN) {
            lines.add(format(
                    "float32 keeps the tolerance %s in the median, but leaves errors of up to %s at the 95th percentile of"
                            + " power, of which three times the tolerance is promised; 'reflectance --method reference'"
                            + " goes further",
                    shown(plan.tolerance()), shown(Tolerances.FLOAT32_PERCENTILE)));
        }
    }

    private void checkTerms(List<String> lines) {
        Expansion expansion = plan.expansion();
        double error = expansion instanceof LowRankExpansion lowRank
                ? lowRank.rootMeanSquareError()
                : expansion.errorBound(expansion.maximumPhase());
        if (error > plan.tolerance()) {
            lines.add(format(
                    "%d %s terms leave an error of %.1g, more than the tolerance %s; give more --terms, or leave it out",
                    expansion.terms(), expansion.kind().label(), error, plan.tolerance()));
        }
    }

    private void checkRadius(int radius, List<String> lines) {
        double sigmaBins = plan.window().sigmaFrequency() * Math.max(map.width(), map.height());
        int needed = new ErrorBudget(plan.tolerance()).neighbourhoodRadius(sigmaBins);
        if (radius < needed) {
            lines.add(format(
                    "radius %d cuts the window's spectrum, which is %.2f DFT bins wide; the tolerance %s takes --radius %d",
                    radius, sigmaBins, plan.tolerance(), needed));
        }
    }

    private void checkWavelengths(int count, List<String> lines) {
        double step = (CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) / (count - 1);
        double needed = coarsestWavelengthStep(plan.window(), plan.range(), plan.tolerance());
        // 1e-9: a step that was planned comes back by way of a count.
        if (step > needed * (1 + 1e-9)) {
            lines.add(format(
                    "wavelengths %s apart miss parts of the orders farthest from the specular direction; the tolerance %s"
                            + " takes --wavelength-step %s",
                    Lengths.format(step),
                    plan.tolerance(),
                    Lengths.format(roundedDown(needed)).replace(" ", "")));
        }
    }

    /**
     * The coarsest step of the wavelength that keeps a tolerance, metres. The power of a lone order is a Gaussian of
     * deviation lambda^2 sigma_f / (sqrt(2) |(u, v)|), for which the trapezoid rule errs by 2 exp(-2 (pi deviation /
     * step)^2).
     */
    static double coarsestWavelengthStep(CoherenceWindow window, VisibleRange range, double tolerance) {
        double shortest = CieTable.MINIMUM_WAVELENGTH;
        double deviation =
                shortest * shortest * window.sigmaFrequency() / (Math.sqrt(2) * Math.max(1e-9, range.longestUv()));
        return Math.PI * deviation * Math.sqrt(2 / Math.log(2 / tolerance));
    }

    private static double roundedDown(double value) {
        return new BigDecimal(value)
                .round(new MathContext(2, RoundingMode.DOWN))
                .doubleValue();
    }

    /** As people write it: 1e-5, not 1.0E-5. */
    private static String shown(double value) {
        return Double.toString(value).replaceFirst("\\.0(E|$)", "$1").replace('E', 'e');
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
