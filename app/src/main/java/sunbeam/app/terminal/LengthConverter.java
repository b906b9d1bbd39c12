package sunbeam.app.terminal;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import sunbeam.precompute.units.LengthFormatException;
import sunbeam.precompute.units.Lengths;

/** A length on the command line with its unit, as in {@code 65um}. Yields metres. */
public final class LengthConverter implements ITypeConverter<Double> {
    @Override
    public Double convert(String text) {
        try {
            return Lengths.parse(text);
        } catch (LengthFormatException failure) {
            throw new TypeConversionException(failure.getMessage());
        }
    }
}
