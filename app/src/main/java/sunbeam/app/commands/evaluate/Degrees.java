package sunbeam.app.commands.evaluate;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/** Angles for people. */
final class Degrees {
    private Degrees() {}

    /** To hundredths, without zeros at the end. */
    static String text(double radians) {
        return new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(Locale.ROOT))
                .format(0.01 * Math.round(100 * Math.toDegrees(radians)));
    }
}
