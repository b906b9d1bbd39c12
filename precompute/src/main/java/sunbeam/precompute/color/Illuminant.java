package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** Relative spectral power of a light at each nanometer from 380 to 780 nm, at least 0, linear between; in any scale. */
public record Illuminant(String name, double[] power) {
    /** Index of the value at 780 nm. */
    public static final int LAST = 400;
    /** Names of the built-in CIE illuminants; E is equal power. */
    public static final List<String> NAMES = List.of("D65", "D50", "A", "E", "F11", "LED-B3");

    // Second differences of a smooth spectrum, relative to its power, from 400 to 700 nm and beyond. D65, for which the
    // wavelengths of method full are designed, has up to 3 % and 8 %; lines of lamps and lasers have 100 %.
    private static final double LARGEST_BEND = 0.04;
    private static final double LARGEST_BEND_AT_ENDS = 0.1;
    // Below this share of the strongest power bends are invisible.
    private static final double FAINT = 0.05;

    public Illuminant {
        if (power.length != LAST + 1 || Arrays.stream(power).anyMatch(value -> !(value >= 0))) {
            throw new IllegalArgumentException("power is a number, not negative, at each nanometer from 380 to 780 nm");
        }
        if (Arrays.stream(power).sum() == 0) {
            throw new IllegalArgumentException("it has no power from 380 to 780 nm");
        }
    }

    public static Illuminant of(String name) {
        double[] power = new double[LAST + 1];
        Arrays.fill(power, 100);
        return new Illuminant(name, name.equals("E") ? power : CieTable.column(name.toLowerCase(Locale.ROOT)));
    }

    Illuminant through(WavelengthBand band) {
        double[] passed = IntStream.rangeClosed(0, LAST)
                .mapToDouble(i -> power[i] * band.coverage(i + 380))
                .toArray();
        return new Illuminant(name + ", " + band, passed);
    }

    public boolean isSmooth() {
        double strongest = Arrays.stream(power).max().orElseThrow();
        return IntStream.range(1, LAST).allMatch(i -> {
            double bend = Math.abs(power[i - 1] - 2 * power[i] + power[i + 1]);
            double largest = i >= 20 && i <= 320 ? LARGEST_BEND : LARGEST_BEND_AT_ENDS;
            return bend <= largest * Math.max(power[i], FAINT * strongest);
        });
    }
}
