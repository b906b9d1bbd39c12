package sunbeam.app.terminal;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Text;

/** Parses and formats sizes of files: {@code 500MB}, {@code 1.5 GB}. */
public final class ByteSize {
    private static final Pattern WRITTEN =
            Pattern.compile("([0-9]{1,15}(?:\\.[0-9]{1,9})?) ?([KMGT]?B)", Pattern.CASE_INSENSITIVE);
    private static final List<String> UNITS = List.of("B", "kB", "MB", "GB", "TB");
    // In bytes: more than any disk has, and far from overflow.
    private static final BigDecimal MOST = new BigDecimal(1L << 60);

    private ByteSize() {}

    /** Returns the bytes of a size in B, kB, MB, GB, TB (any case), or throws IllegalArgumentException that says what is expected. */
    public static long parse(String text) {
        Matcher written = WRITTEN.matcher(text.strip());
        if (!written.matches()) {
            throw new IllegalArgumentException(
                    "'" + text + "' is no size; give a number with its unit (kB, MB, GB, TB), for example 2GB");
        }
        int thousands = UNITS.indexOf(written.group(2).toUpperCase(Locale.ROOT).replace('K', 'k'));
        BigDecimal bytes = new BigDecimal(written.group(1)).scaleByPowerOfTen(3 * thousands);
        if (bytes.compareTo(MOST) > 0) {
            throw new IllegalArgumentException("'" + text + "' is more than any disk has; give less");
        }
        return bytes.setScale(0, RoundingMode.HALF_UP).longValueExact();
    }

    /** Formats a size in the decimal unit that leaves one to three digits before the point: {@code 207.1 MB}. */
    public static String format(long bytes) {
        double value = bytes;
        int unit = 0;
        // A value that would be rounded to 1000.0 takes the next unit.
        while (value >= 999.95 && unit < UNITS.size() - 1) {
            value /= 1000;
            unit++;
        }
        return unit == 0 ? bytes + " B" : Text.format("%.1f %s", value, UNITS.get(unit));
    }
}
