package sunbeam.app.commands.color;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.io.PrintWriter;
import java.util.Locale;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.units.Lengths;

/** A scan so small that it tells no colour: light that short a coherence length has lies in the mirror's everywhere. */
final class SmallScan {
    /** From half of the visible band on, metres, an order has no hue of its own. */
    private static final double NO_HUE = 200e-9;

    private SmallScan() {}

    /**
     * Warns where the scan's size, not the light that was asked for, leaves no order outside the mirror's reach.
     *
     * @param asked before the scan's size limited it
     * @return whether the colours can only be a mistake: orders are wider than half of the visible band everywhere
     */
    static boolean judge(ColorReport report, Patch patch, Choices asked, PrintWriter err) {
        double limited = ScanLimit.of(asked, patch).choices().get(COHERENCE_LENGTH);
        if (!(limited < asked.get(COHERENCE_LENGTH)) || !report.isAllMirror()) {
            return false;
        }
        double narrowest = report.narrowestOrder();
        // Widths go with the inverse of the size; just outside the mirror's reach, orders are 130 nm wide or less.
        double needed = patch.shorterSide() * report.farthest();
        err.println(Messages.warning(String.format(
                Locale.ROOT,
                "%s: a scan of %s is too small to tell any colour: at every angle an order is %.0f nm wide or more, of a"
                        + " visible band of 400 nm; scan %s or more, better 20 um",
                report.name(),
                Lengths.rounded(patch.shorterSide(), 3),
                1e9 * narrowest,
                Lengths.rounded(needed, 2))));
        err.flush();
        return narrowest >= NO_HUE;
    }
}
