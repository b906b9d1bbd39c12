package sunbeam.app.evaluate;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import sunbeam.app.gpu.MethodKind;

/** A method on the command line, in any case; says why method {@code gem} of the other commands is none here. */
final class ResponseMethodConverter implements ITypeConverter<Responses.Method> {
    @Override
    public Responses.Method convert(String text) {
        for (Responses.Method method : Responses.Method.values()) {
            if (method.name().equalsIgnoreCase(text)) {
                return method;
            }
        }
        String known = Arrays.stream(Responses.Method.values())
                .map(method -> method.name().toLowerCase(Locale.ROOT))
                .collect(Collectors.joining(", "));
        if (MethodKind.GEM.label().equalsIgnoreCase(text)) {
            throw new TypeConversionException("gem has colours but no power at a wavelength, so there is no response to"
                    + " evaluate; give one of " + known);
        }
        throw new TypeConversionException("'" + text + "' is no method; give one of " + known);
    }
}
