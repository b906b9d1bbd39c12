package sunbeam.precompute.color;

import java.util.Locale;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Lengths;

/**
 * A part of the visible band: a filter, or a line, which is a nanometer wide.
 *
 * @param firstNanometers where it begins
 * @param lastNanometers where it ends
 */
public record WavelengthBand(double firstNanometers, double lastNanometers) {
    /** All of it. */
    public static final WavelengthBand VISIBLE = new WavelengthBand(380, 780);

    private static final Pattern BETWEEN = Pattern.compile("\\.\\.");
    private static final double LINE_NANOMETERS = 1;

    public WavelengthBand {
        if (!(firstNanometers >= 380 && lastNanometers <= 780)) {
            throw new IllegalArgumentException("reaches beyond 380 to 780 nm");
        }
        if (!(lastNanometers - firstNanometers >= LINE_NANOMETERS - 1e-6)) {
            throw new IllegalArgumentException("is narrower than 1 nm, which a single wavelength stands for");
        }
    }

    /**
     * From {@code 532nm} or {@code 500nm..600nm}.
     *
     * @throws IllegalArgumentException for what is neither, naming the text
     */
    public static WavelengthBand parse(String text) {
        String[] ends = BETWEEN.split(text.strip(), -1);
        try {
            double first = Math.rint(1e12 * Lengths.parse(ends[0])) / 1e3;
            if (ends.length == 1) {
                // At the ends of the visible band a line lies within it.
                double begin = Math.max(380, Math.min(780 - LINE_NANOMETERS, first - LINE_NANOMETERS / 2));
                double from = first >= 380 && first <= 780 ? begin : first;
                return new WavelengthBand(from, from + LINE_NANOMETERS);
            }
            if (ends.length == 2) {
                return new WavelengthBand(first, Math.rint(1e12 * Lengths.parse(ends[1])) / 1e3);
            }
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException(
                    Quoted.of(text) + " " + wrong.getMessage() + "; give a wavelength, 532nm, or a band, 500nm..600nm",
                    wrong);
        }
        throw new IllegalArgumentException(
                Quoted.of(text) + " is neither a wavelength, 532nm, nor a band, 500nm..600nm");
    }

    /** How much of the nanometer around a wavelength lies in it, 0 to 1; of half a nanometer at the ends of 380 to 780. */
    double coverage(int nanometers) {
        double first = Math.max(380, nanometers - 0.5);
        double last = Math.min(780, nanometers + 0.5);
        return Math.max(0, Math.min(last, lastNanometers) - Math.max(first, firstNanometers)) / (last - first);
    }

    /** As {@link #parse} reads it. */
    @Override
    public String toString() {
        double width = lastNanometers - firstNanometers;
        return width <= LINE_NANOMETERS + 1e-6
                ? number(0.5 * (firstNanometers + lastNanometers)) + "nm"
                : number(firstNanometers) + "nm.." + number(lastNanometers) + "nm";
    }

    private static String number(double nanometers) {
        return String.format(Locale.ROOT, "%.3f", nanometers).replaceFirst("\\.?0+$", "");
    }
}
