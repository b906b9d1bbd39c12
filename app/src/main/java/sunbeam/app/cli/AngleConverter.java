package sunbeam.app.cli;

import java.util.Locale;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import sunbeam.precompute.units.Decimals;

/** An angle on the command line: degrees ({@code 75}, {@code 75deg}) or radians ({@code 1.3rad}). Yields radians. */
public final class AngleConverter implements ITypeConverter<Double> {
    @Override
    public Double convert(String text) {
        String value = text.strip().toLowerCase(Locale.ROOT);
        if (value.endsWith("rad")) {
            return number(text, value.substring(0, value.length() - 3));
        }
        if (value.endsWith("deg")) {
            return Math.toRadians(number(text, value.substring(0, value.length() - 3)));
        }
        return Math.toRadians(number(text, value));
    }

    private static double number(String text, String digits) {
        return Decimals.parse(digits)
                .orElseThrow(() -> new TypeConversionException(
                        "'" + text + "' is not an angle; give degrees as in 75, or radians as in 1.3rad"));
    }
}
