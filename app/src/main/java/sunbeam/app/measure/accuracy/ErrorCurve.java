package sunbeam.app.measure.accuracy;

import java.util.ArrayList;
import java.util.List;
import sunbeam.app.measure.errors.ErrorStatistics;

/**
 * Errors over one quantity that was varied.
 *
 * @param name for legends and columns: letters, digits, blanks
 * @param x values of what was varied
 * @param errors statistics for each of them
 */
public record ErrorCurve(String name, List<Double> x, List<ErrorStatistics> errors) {
    public ErrorCurve {
        x = List.copyOf(x);
        errors = List.copyOf(errors);
        if (x.size() != errors.size()) {
            throw new IllegalArgumentException(name + ": " + x.size() + " values, " + errors.size() + " errors");
        }
    }

    /** A single point. */
    public static ErrorCurve point(String name, double x, ErrorStatistics errors) {
        return new ErrorCurve(name, List.of(x), List.of(errors));
    }

    /** Collects a curve point by point. */
    static final class Builder {
        private final String name;
        private final List<Double> x = new ArrayList<>();
        private final List<ErrorStatistics> errors = new ArrayList<>();

        Builder(String name) {
            this.name = name;
        }

        void add(double value, double... samples) {
            x.add(value);
            errors.add(ErrorStatistics.of(samples));
        }

        ErrorCurve build() {
            return new ErrorCurve(name, x, errors);
        }
    }
}
