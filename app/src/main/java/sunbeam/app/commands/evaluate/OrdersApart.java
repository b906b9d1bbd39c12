package sunbeam.app.commands.evaluate;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.Optional;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.units.Lengths;

/**
 * Whether light under a coherence window tells a period's orders apart. They stand 1 / period apart in frequency, and each is a
 * Gaussian: nearer than three deviations, a ridge is drawn towards the mirror and towards its neighbors by per cents.
 *
 * @param period metres
 * @param window under which light looks
 * @param side the scan's shorter one, metres: no window may be longer; infinite for a surface that repeats
 */
record OrdersApart(double period, CoherenceWindow window, double side) {
    // The mirror's amplitude is exp(-9 / 2), 1 %, of its top there.
    private static final double LEAST = 3;

    boolean areTold() {
        return 1 / period >= LEAST * window.sigmaFrequency();
    }

    /** The coherence length, metres, from which on they are told apart. */
    private double needed() {
        return CoherenceWindow.ofCoherenceLength(1).sigmaFrequency() * LEAST * period;
    }

    /** Why there is no ridge, and what shows one; empty where there is one. */
    Optional<String> shortfall() {
        if (areTold()) {
            return Optional.empty();
        }
        String longer = Lengths.format(new BigDecimal(needed())
                .round(new MathContext(2, RoundingMode.UP))
                .doubleValue());
        String remedy = needed() < side
                ? OptionOrigin.INSTANCE.name(MethodSettings.COHERENCE_LENGTH) + " " + longer
                : "a scan whose shorter side is " + longer;
        return Optional.of(String.format(
                Locale.ROOT,
                "light with a coherence length of %s sees a period of about %s %.1f times at once, too few to tell its orders apart; %s or more does",
                Lengths.rounded(window.coherenceLength(), 4),
                Lengths.rounded(period, 2),
                window.coherenceLength() / period,
                remedy));
    }
}
