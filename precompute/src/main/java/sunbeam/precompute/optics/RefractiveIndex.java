package sunbeam.precompute.optics;

import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;

/** Refractive index n + i k of a material in air, constant or tabulated over wavelengths. Immutable. */
public final class RefractiveIndex {
    /** Index of keratin (thesis section 3.3.2). */
    public static final RefractiveIndex KERATIN = constant(1.5, 0);

    private static final double LARGEST = 100;
    private static final Pattern NUMBER = Pattern.compile(
            "([0-9]*\\.?[0-9]+(?:[eE][+-]?[0-9]+)?)(?:\\s*\\+\\s*([0-9]*\\.?[0-9]+(?:[eE][+-]?[0-9]+)?)i)?");

    private final double[] wavelengths;
    private final double[] real;
    private final double[] imaginary;

    private RefractiveIndex(double[] wavelengths, double[] real, double[] imaginary) {
        for (int i = 0; i < real.length; i++) {
            check(real[i], imaginary[i]);
        }
        this.wavelengths = wavelengths;
        this.real = real;
        this.imaginary = imaginary;
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
        return new RefractiveIndex(new double[1], new double[] {n}, new double[] {k});
    }

    /**
     * Returns an index that is linear between tabulated wavelengths and constant beyond them.
     *
     * @param wavelengths meters, ascending
     * @throws IllegalArgumentException when wavelengths do not ascend or an index is out of range
     */
    public static RefractiveIndex tabulated(double[] wavelengths, double[] n, double[] k) {
        for (int i = 1; i < wavelengths.length; i++) {
            if (!(wavelengths[i] > wavelengths[i - 1])) {
                throw new IllegalArgumentException("wavelengths do not ascend");
            }
        }
        return new RefractiveIndex(wavelengths.clone(), n.clone(), k.clone());
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

    /** True if the index is the same at all wavelengths. */
    public boolean isConstant() {
        return real.length == 1;
    }

    /** Returns the reflectance along the normal, |(n - 1 + i k) / (n + 1 + i k)|^2, for a wavelength in meters. */
    public double reflectance(double wavelength) {
        double n = at(real, wavelength);
        double k = at(imaginary, wavelength);
        return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    }

    /** Returns Schlick's reflectance for a wavelength in meters and the cosine of the angle between the half vector and the view. */
    public double reflectance(double wavelength, double cosThetaD) {
        double normal = reflectance(wavelength);
        return normal + (1 - normal) * Math.pow(Math.max(0, 1 - cosThetaD), 5);
    }

    /** True if this is keratin's index, the default. */
    public boolean isStandard() {
        return equals(KERATIN);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof RefractiveIndex index
                && Arrays.equals(wavelengths, index.wavelengths)
                && Arrays.equals(real, index.real)
                && Arrays.equals(imaginary, index.imaginary);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(
                new int[] {Arrays.hashCode(wavelengths), Arrays.hashCode(real), Arrays.hashCode(imaginary)});
    }

    private double at(double[] values, double wavelength) {
        int found = Arrays.binarySearch(wavelengths, wavelength);
        if (values.length == 1 || found >= 0) {
            return values[Math.max(0, Math.min(found, values.length - 1))];
        }
        int after = -found - 1;
        if (after == 0 || after == values.length) {
            return values[Math.min(after, values.length - 1)];
        }
        double share = (wavelength - wavelengths[after - 1]) / (wavelengths[after] - wavelengths[after - 1]);
        return values[after - 1] + share * (values[after] - values[after - 1]);
    }

    /** Returns a text for metadata: "1.5", "0.97 + 6.5i", or a note that it is tabulated. */
    public String describe() {
        if (!isConstant()) {
            return Text.format(
                    "tabulated from %.0f to %.0f nm", wavelengths[0] * 1e9, wavelengths[wavelengths.length - 1] * 1e9);
        }
        return imaginary[0] == 0 ? Double.toString(real[0]) : real[0] + " + " + imaginary[0] + "i";
    }
}
