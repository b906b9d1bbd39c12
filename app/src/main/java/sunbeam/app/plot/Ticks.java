package sunbeam.app.plot;

import java.util.Locale;

/**
 * Round numbers along an axis.
 *
 * @param values ascending, all within the axis
 * @param decimals digits after the point that tell them apart
 */
record Ticks(double[] values, int decimals) {

    /** At most about {@code wanted} multiples of 1, 2 or 5 times a power of ten. */
    static Ticks between(double low, double high, int wanted) {
        double rough = (high - low) / Math.max(1, wanted);
        double power = Math.pow(10, Math.floor(Math.log10(rough)));
        double mantissa = rough / power;
        double step = power * (mantissa <= 1 ? 1 : mantissa <= 2 ? 2 : mantissa <= 5 ? 5 : 10);
        // 1e-9: an end that is a multiple but for rounding is one.
        long first = (long) Math.ceil(low / step - 1e-9);
        long last = (long) Math.floor(high / step + 1e-9);
        double[] values = new double[(int) Math.max(0, last - first + 1)];
        for (int i = 0; i < values.length; i++) {
            values[i] = (first + i) * step;
        }
        return new Ticks(values, (int) Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
    }

    /** The whole powers of ten between two positive numbers. */
    static Ticks powersOfTen(double low, double high) {
        int first = (int) Math.ceil(Math.log10(low) - 1e-9);
        int last = (int) Math.floor(Math.log10(high) + 1e-9);
        double[] values = new double[Math.max(0, last - first + 1)];
        for (int i = 0; i < values.length; i++) {
            values[i] = Math.pow(10, first + i);
        }
        return new Ticks(values, 0);
    }

    String label(int index) {
        return String.format(Locale.ROOT, "%." + decimals + "f", values[index] + 0.0);
    }
}
