package sunbeam.precompute.optics;

import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/**
 * Refractive index n + i k of a material in air by wavelength in meters, linear between entries and constant beyond them; n has at least
 * one, k is 0 without any. Neither may change afterwards.
 */
public record RefractiveIndex(NavigableMap<Double, Double> real, NavigableMap<Double, Double> imaginary) {
    /** Index of keratin (thesis section 3.3.2). */
    public static final RefractiveIndex KERATIN = constant(1.5, 0);

    private static final double LARGEST = 100;
    private static final Pattern NUMBER = Pattern.compile(
            "([0-9]*\\.?[0-9]+(?:[eE][+-]?[0-9]+)?)(?:\\s*\\+\\s*([0-9]*\\.?[0-9]+(?:[eE][+-]?[0-9]+)?)i)?");

    /** Throws IllegalArgumentException for an index out of range. */
    public RefractiveIndex {
        TreeSet<Double> wavelengths = new TreeSet<>(real.keySet());
        wavelengths.addAll(imaginary.keySet());
        for (double wavelength : wavelengths) {
            check(at(real, wavelength), at(imaginary, wavelength));
        }
    }

    private static void check(double n, double k) {
        if (!(n > 0 && n <= LARGEST && k >= 0 && k <= LARGEST)) {
            throw new IllegalArgumentException(
                    "index " + n + " + " + k + "i: n must be above 0, k at least 0, both at most " + (int) LARGEST);
        }
        if (Math.hypot(n - 1, k) < 1e-3) {
            throw new IllegalArgumentException("an index of 1 reflects nothing");
        }
    }

    public static RefractiveIndex constant(double n, double k) {
        return new RefractiveIndex(new TreeMap<>(Map.of(0.0, n)), new TreeMap<>(Map.of(0.0, k)));
    }

    /** Parses {@code 1.56} or {@code 0.97+6.5i}. */
    public static RefractiveIndex parse(String text) {
        Matcher matcher = NUMBER.matcher(text.strip());
        if (!matcher.matches()) {
            throw new IllegalArgumentException(
                    "it is neither an index such as 1.56 or 0.97+6.5i nor a file (.csv)" + Decimals.commaRemedy(text));
        }
        double k = matcher.group(2) == null ? 0 : Double.parseDouble(matcher.group(2));
        return constant(Double.parseDouble(matcher.group(1)), k);
    }

    public boolean isConstant() {
        return real.size() == 1 && imaginary.size() <= 1;
    }

    /** Returns the reflectance along the normal, |(n - 1 + i k) / (n + 1 + i k)|^2, for a wavelength in meters. */
    public double reflectance(double wavelength) {
        double n = at(real, wavelength);
        double k = at(imaginary, wavelength);
        return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    }

    private static double at(NavigableMap<Double, Double> values, double wavelength) {
        return values.isEmpty() ? 0 : Lagrange.between(values, wavelength);
    }

    /** Returns Schlick's reflectance at a wavelength in meters for the cosine of the angle between the half vector and the view. */
    public double reflectance(double wavelength, double cosThetaD) {
        return schlick(reflectance(wavelength), cosThetaD);
    }

    /** Returns Schlick's reflectance (1994) for that along the normal. */
    public static double schlick(double normal, double cosThetaD) {
        return normal + (1 - normal) * Math.pow(Math.max(0, 1 - cosThetaD), 5);
    }

    public boolean isStandard() {
        return equals(KERATIN);
    }

    /** Returns a text for metadata: "1.5", "0.97 + 6.5i", or a note that it is tabulated. */
    public String describe() {
        if (!isConstant()) {
            return Text.format("tabulated from %.0f to %.0f nm", real.firstKey() * 1e9, real.lastKey() * 1e9);
        }
        double k = at(imaginary, 0);
        return k == 0 ? Double.toString(at(real, 0)) : at(real, 0) + " + " + k + "i";
    }
}
