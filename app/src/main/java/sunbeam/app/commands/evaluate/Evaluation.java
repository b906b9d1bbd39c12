package sunbeam.app.commands.evaluate;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Optional;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.evaluation.FirstOrder;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.evaluation.Ridge;
import sunbeam.precompute.evaluation.RidgeTracker;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * A patch's response in the plane of incidence beside the period of its heights.
 *
 * @param heights what the heights tell of the periods and directions that were asked for
 * @param ridge of the first order; empty where light does not tell its orders apart, or shows none
 * @param noRidge why there is none; empty where there is one
 */
record Evaluation(
        Patch patch, GratingPeriod heights, ResponseMatrix response, Optional<Ridge> ridge, Optional<String> noRidge) {
    // Deviations of the window's spectrum between orders, which are Gaussians 1 / period apart: nearer, the mirror's,
    // of which 1 % is
    // left at three, draws a ridge aside by per cents.
    private static final double APART = 3;

    /** @param order where the first order is looked for */
    static Evaluation of(
            Patch patch, GratingPeriod heights, FirstOrder order, ResponseMatrix response, CoherenceWindow window) {
        double period = heights.isTold() ? heights.period() : order.middle();
        boolean apart = 1 / period >= APART * window.sigmaFrequency();
        Optional<Ridge> ridge =
                apart ? new RidgeTracker(response, window.sigmaFrequency()).follow(order) : Optional.empty();
        Optional<String> noRidge = ridge.isPresent()
                ? Optional.empty()
                : Optional.of(apart ? noneNear(order) : ordersRunTogether(patch, period, window));
        return new Evaluation(patch, heights, response, ridge, noRidge);
    }

    private static String noneNear(FirstOrder order) {
        return Text.format(
                "the response has no ridge of periods from %s to %s at 3 --wavelengths or more within --angles; choose more of them",
                Lengths.rounded(order.shortest(), 3), Lengths.rounded(order.longest(), 3));
    }

    private static String ordersRunTogether(Patch patch, double period, CoherenceWindow window) {
        double needed = CoherenceWindow.ofCoherenceLength(1).sigmaFrequency() * APART * period;
        String longer = Lengths.format(new BigDecimal(needed)
                .round(new MathContext(2, RoundingMode.UP))
                .doubleValue());
        // No window is longer than a scan that does not repeat.
        boolean possible = patch.repetition() != Patch.Repetition.NONE || needed < patch.shorterSide();
        return Text.format(
                "light with a coherence length of %s sees a period of about %s %.1f times at once, too few to tell its orders apart; %s or more does",
                Lengths.rounded(window.coherenceLength(), 4),
                Lengths.rounded(period, 2),
                window.coherenceLength() / period,
                possible
                        ? OptionOrigin.INSTANCE.name(MethodSettings.COHERENCE_LENGTH) + " " + longer
                        : "a scan whose shorter side is " + longer);
    }

    /** The period of the heights where it may be quoted. */
    Optional<GratingPeriod> told() {
        return heights.isTold() ? Optional.of(heights) : Optional.empty();
    }

    /** A name, the light and the azimuth. */
    String title(String name) {
        return Text.format(
                "%s, light at %s degrees, azimuth %s degrees",
                name,
                degrees(response.grid().plane().thetaI()),
                degrees(response.grid().plane().azimuth()));
    }

    /** To hundredths, without zeros at the end. */
    private static String degrees(double radians) {
        return BigDecimal.valueOf(Math.round(100 * Math.toDegrees(radians)), 2)
                .stripTrailingZeros()
                .toPlainString();
    }
}
