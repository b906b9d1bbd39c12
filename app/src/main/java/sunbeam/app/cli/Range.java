package sunbeam.app.cli;

import java.util.stream.IntStream;
import picocli.CommandLine.TypeConversionException;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.units.Decimals;

/** Evenly spaced values {@code minimum, minimum + step, ...} up to {@code maximum}, in the option's unit; 0:1:0.1 ends at 1. */
public record Range(double minimum, double maximum, double step) {
    private static final int MOST_VALUES = 1_000_000;
    /** Tolerance for rounding of (maximum - minimum) / step, in steps. */
    private static final double SLACK = 1e-9;

    /** @throws IllegalArgumentException when the bounds or the step do not make a range of 1 to 1,000,000 values */
    public Range {
        if (!(Double.isFinite(minimum) && Double.isFinite(maximum) && minimum <= maximum)) {
            throw new IllegalArgumentException("the minimum " + minimum + " must not exceed the maximum " + maximum);
        }
        if (!(step > 0 && Double.isFinite(step))) {
            throw new IllegalArgumentException("the step must be positive, got " + step);
        }
        if ((maximum - minimum) / step >= MOST_VALUES) {
            throw new IllegalArgumentException(
                    "the step " + step + " gives more than " + MOST_VALUES + " values; choose a larger one");
        }
    }

    /** Refuses an option's range that leaves the interval from {@code least} to {@code most}, but for rounding of 1e-6. */
    public void requireWithin(String option, double least, double most, String unit) {
        UsageException.throwIf(
                minimum < least - 1e-6 || maximum > most + 1e-6,
                option + " " + rounded(minimum) + ":" + rounded(maximum) + ":" + rounded(step)
                        + " leaves the range " + rounded(least) + " to " + rounded(most) + " " + unit
                        + "; give values within");
    }

    private static String rounded(double value) {
        return Decimals.format(Math.rint(1e6 * value) / 1e6);
    }

    public int count() {
        return 1 + (int) Math.floor((maximum - minimum) / step + SLACK);
    }

    public double[] values() {
        return IntStream.range(0, count())
                .mapToDouble(index -> Math.min(maximum, minimum + index * step))
                .toArray();
    }

    /** Parses {@code min:max:step}, or one number, in the option's unit. */
    public static Range parse(String text) {
        String[] parts = text.split(":", -1);
        if (parts.length != 1 && parts.length != 3) {
            throw new TypeConversionException("'" + text + "' is not a range; give min:max:step as in 380:780:5");
        }
        try {
            double first = number(parts[0]);
            return parts.length == 1
                    ? new Range(first, first, 1)
                    : new Range(first, number(parts[1]), number(parts[2]));
        } catch (IllegalArgumentException failure) {
            throw new TypeConversionException("'" + text + "' is not a range: " + failure.getMessage());
        }
    }

    private static double number(String text) {
        return Decimals.parse(text)
                .orElseThrow(() -> new IllegalArgumentException(
                        "'" + text + "' is not a number; give min:max:step as in 380:780:5"));
    }
}
