package sunbeam.precompute.color;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.NavigableMap;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Relative spectral power of a light at each nanometer from 380 to 780 nm, at least 0, linear between; in any scale. */
public record Illuminant(String name, double[] power) {
    /** Index of the value at 780 nm. */
    public static final int LAST = CieTable.LAST_NANOMETER - CieTable.FIRST_NANOMETER;
    /** Names of the built-in CIE illuminants; E is equal power. */
    public static final List<String> NAMES = List.of("D65", "D50", "A", "E", "F11", "LED-B3");

    // The largest relative error of an order in smooth light; beyond 720 nm, where eyes see a thousandth, it may be
    // larger. Daylight, for which plans are made, has 1.0 and 3.1 %; of CIE 15's other lamps those without lines have
    // 1.1 and 1.2 %, with lines 2.4 and 5.7 % or more.
    private static final double LARGEST_ERROR = 0.0125;
    private static final double LARGEST_ERROR_OF_DARK_RED = 0.035;
    private static final int DARK_RED = 720;
    // Method full steps by this much of 1 / lambda at a tolerance of 1e-3, 1 / nm.
    private static final double STEP = (1.0 / CieTable.FIRST_NANOMETER - 1.0 / CieTable.LAST_NANOMETER) / 60;
    // Share of the strongest power below which errors do not count.
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

    /** True if equal steps of 1 / lambda, those of method full, integrate the light of each order one step wide as exactly as of daylight. */
    public boolean isSmooth() {
        double faint = FAINT * Arrays.stream(power).max().orElseThrow() * Math.sqrt(2 * Math.PI);
        return IntStream.iterate(CieTable.FIRST_NANOMETER, nm -> nm <= CieTable.LAST_NANOMETER, nm -> nm + 3)
                .allMatch(middle -> {
                    double light = ofOrder(middle, 1.0 / 16, 0);
                    double largest = middle > DARK_RED ? LARGEST_ERROR_OF_DARK_RED : LARGEST_ERROR;
                    return DoubleStream.of(0, 0.25, 0.5, 0.75)
                            .allMatch(phase ->
                                    Math.abs(ofOrder(middle, 1, phase) - light) <= largest * Math.max(light, faint));
                });
    }

    /** Returns the light of an order by the trapezoid rule; step and phase are shares of the order's deviation. */
    private double ofOrder(int middle, double step, double phase) {
        return IntStream.rangeClosed((int) (-6 / step), (int) (6 / step))
                .mapToDouble(i -> i * step + phase)
                .map(x -> step * Math.exp(-0.5 * x * x) * at(1 / (1.0 / middle + x * STEP)))
                .sum();
    }

    private double at(double nanometers) {
        double index = Math.max(0, Math.min(LAST, nanometers - CieTable.FIRST_NANOMETER));
        int i = (int) Math.min(LAST - 1, index);
        return power[i] + (index - i) * (power[i + 1] - power[i]);
    }
}
