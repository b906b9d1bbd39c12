package sunbeam.app.terminal;

import java.util.OptionalDouble;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import sunbeam.precompute.units.Decimals;

/** A range on the command line, {@code min:max:step}, each a plain number in the option's unit. */
public final class RangeConverter implements ITypeConverter<Range> {
    @Override
    public Range convert(String text) {
        String[] parts = text.split(":", -1);
        if (parts.length != 3) {
            throw new TypeConversionException("'" + text + "' is not a range; give min:max:step as in 380:780:5");
        }
        try {
            return new Range(number(text, parts[0]), number(text, parts[1]), number(text, parts[2]));
        } catch (IllegalArgumentException failure) {
            throw new TypeConversionException("'" + text + "' is not a range: " + failure.getMessage());
        }
    }

    private static double number(String text, String part) {
        OptionalDouble value = Decimals.parse(part);
        return value.orElseThrow(() -> new TypeConversionException(
                "'" + text + "' is not a range: '" + part + "' is not a number; give min:max:step as in 380:780:5"));
    }
}
