package sunbeam.app.commands.evaluate;

import java.util.Arrays;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import sunbeam.precompute.method.GemMethod;

/** A method on the command line, in any case; says why method {@code gem} of the other commands is none here. */
final class ResponseMethodConverter implements ITypeConverter<ResponseMethod> {
    @Override
    public ResponseMethod convert(String text) {
        for (ResponseMethod method : ResponseMethod.values()) {
            if (method.name().equalsIgnoreCase(text)) {
                return method;
            }
        }
        String known = Arrays.stream(ResponseMethod.values())
                .map(ResponseMethod::label)
                .collect(Collectors.joining(", "));
        if (GemMethod.TYPE.label().equalsIgnoreCase(text)) {
            throw new TypeConversionException("gem has colors but no power at a wavelength, so there is no response to"
                    + " evaluate; give one of " + known);
        }
        throw new TypeConversionException("'" + text + "' is no method; give one of " + known);
    }
}
