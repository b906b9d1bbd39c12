package sunbeam.app.terminal;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import sunbeam.precompute.units.Angles;

/** An angle on the command line: degrees ({@code 75}, {@code 75deg}) or radians ({@code 1.3rad}). Yields radians. */
public final class AngleConverter implements ITypeConverter<Double> {
    @Override
    public Double convert(String text) {
        try {
            return Angles.parse(text);
        } catch (IllegalArgumentException failure) {
            throw new TypeConversionException(failure.getMessage());
        }
    }
}
