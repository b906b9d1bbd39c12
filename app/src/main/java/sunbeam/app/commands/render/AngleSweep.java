package sunbeam.app.commands.render;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import sunbeam.precompute.units.Angles;

/**
 * Angles at even distances.
 *
 * @param from first, radians
 * @param to last, radians
 */
public record AngleSweep(double from, double to) {

    /**
     * The angle of a frame. A sweep of whole turns leaves its last angle out, which is the first again, so that an
     * animation of it runs on without a jolt.
     *
     * @param frame from 0
     * @param frames their number
     */
    double at(int frame, int frames) {
        int steps = isWholeTurns() ? frames : frames - 1;
        return steps == 0 ? from : from + (to - from) * frame / steps;
    }

    private boolean isWholeTurns() {
        double turns = (to - from) / (2 * Math.PI);
        return Math.abs(turns) > 0.5 && Math.abs(turns - Math.rint(turns)) < 1e-9;
    }

    /** From {@code -60:60}. */
    public static final class Converter implements ITypeConverter<AngleSweep> {
        @Override
        public AngleSweep convert(String text) {
            String[] parts = text.split(":", -1);
            if (parts.length != 2) {
                throw new TypeConversionException(
                        "'" + text + "' is not a sweep; give FROM:TO in degrees as in -60:60");
            }
            try {
                return new AngleSweep(Angles.parse(parts[0]), Angles.parse(parts[1]));
            } catch (IllegalArgumentException failure) {
                throw new TypeConversionException(failure.getMessage());
            }
        }
    }
}
