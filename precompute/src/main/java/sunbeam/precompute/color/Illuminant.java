package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.NavigableMap;
import java.util.stream.IntStream;

/** Relative spectral power of a light at each nanometer from 380 to 780 nm, at least 0, linear between; in any scale. */
public record Illuminant(String name, double[] power) {
    /** Index of the value at 780 nm. */
    public static final int LAST = CieTable.LAST_NANOMETER - CieTable.FIRST_NANOMETER;
    /** Names of the built-in CIE illuminants; E is equal power. */
    public static final List<String> NAMES = List.of("D65", "D50", "A", "E", "F11", "LED-B3");

    // Second differences of a smooth spectrum, relative to its power: from 400 to 500 nm, to 700 nm, where the nodes of
    // method full, at equal steps of 1 / lambda, are farther apart, and beyond. D65, for which they are designed, has
    // up to 3 %, 2 % and 8 %; a blue LED, 23 nm wide at half maximum, has 5 % on its flank; lines have 100 %.
    private static final double LARGEST_BLUE_BEND = 0.06;
    private static final double LARGEST_BEND = 0.03;
    private static final double LARGEST_BEND_AT_ENDS = 0.12;
    // Share of the strongest power below which bends do not count.
    private static final double FAINT = 0.01;

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

    /**
     * Returns the light of a table of power by wavelength in nanometers, which must reach from 380 to 780 nm: smooth between rows that resolve
     * its spectrum, else linear. Throws IllegalArgumentException for negative power or none.
     */
    public static Illuminant ofRows(String name, NavigableMap<Double, Double> power) {
        return new Illuminant(name, new SpectralRows(power).perNanometer());
    }

    Illuminant through(WavelengthBand band) {
        double[] passed = IntStream.rangeClosed(0, LAST)
                .mapToDouble(i -> power[i] * band.coverage(i + CieTable.FIRST_NANOMETER))
                .toArray();
        return new Illuminant(name + ", " + band, passed);
    }

    public boolean isSmooth() {
        double strongest = Arrays.stream(power).max().orElseThrow();
        return IntStream.range(1, LAST).allMatch(i -> {
            double bend = Math.abs(power[i - 1] - 2 * power[i] + power[i + 1]);
            double largest = i < 20 || i > 320 ? LARGEST_BEND_AT_ENDS : i < 120 ? LARGEST_BLUE_BEND : LARGEST_BEND;
            return bend <= largest * Math.max(power[i], FAINT * strongest);
        });
    }
}
