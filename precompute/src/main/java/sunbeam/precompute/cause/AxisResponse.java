package sunbeam.precompute.cause;

import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.resample.InterpolationDesign;

/**
 * What bins lend to a frequency along one axis.
 *
 * @param period of the patch along the axis, metres
 * @param sigma standard deviation of the Gaussian, cycles per metre
 * @param form what stands for it
 */
record AxisResponse(double period, double sigma, Form form) {
    // exp(-9^2 / 2) = 3e-18; interpolation spreads some grid steps farther.
    private static final double REACH = 9;
    private static final int MARGIN = 2;

    /** What stands for the Gaussian. */
    sealed interface Form {
        /** What stands for it along y. */
        default Form alongY() {
            return this;
        }
    }

    /** Itself. */
    record Exact() implements Form {}

    /** A few bins. */
    record Nearest(int radius, int radiusY, Neighbourhood.Anchor anchor) implements Form {
        static Nearest of(Neighbourhood bins) {
            return new Nearest(bins.radiusX(), bins.radiusY(), bins.anchor());
        }

        @Override
        public Nearest alongY() {
            return new Nearest(radiusY, radiusY, anchor);
        }
    }

    /**
     * A grid.
     *
     * @param deviation of the Gaussian in grid steps
     */
    record Interpolated(double deviation, DoubleBinaryOperator response) implements Form {
        static Interpolated of(InterpolationDesign design) {
            return new Interpolated(design.deviation(), design.response());
        }
    }

    /** The Gaussian itself. */
    AxisResponse exact() {
        return new AxisResponse(period, sigma, new Exact());
    }

    /** The bins that lend anything. */
    int[] bins(double frequency) {
        double position = frequency * period;
        if (form instanceof Nearest nearest) {
            boolean floor = nearest.anchor() == Neighbourhood.Anchor.FLOOR;
            int middle = (int) (floor ? Math.floor(position) : Math.rint(position));
            return IntStream.rangeClosed(middle - nearest.radius(), middle + nearest.radius())
                    .toArray();
        }
        double reach = REACH * sigma * period + MARGIN;
        return IntStream.rangeClosed((int) Math.ceil(position - reach), (int) Math.floor(position + reach))
                .toArray();
    }

    /** The share of one bin. */
    double at(double frequency, int bin) {
        double away = frequency - bin / period;
        if (form instanceof Interpolated grid) {
            double step = sigma / grid.deviation();
            return grid.response().applyAsDouble(frequency / step, bin / (period * step));
        }
        return Math.exp(-0.5 * Math.pow(away / sigma, 2));
    }
}
