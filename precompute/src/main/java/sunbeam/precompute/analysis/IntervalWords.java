package sunbeam.precompute.analysis;

import sunbeam.precompute.units.Decimals;

/** A period and its interval for people: as many digits as the interval leaves known, the same for all three numbers. */
public final class IntervalWords {
    private static final double NANOMETRES = 1e9;

    private IntervalWords() {}

    /**
     * "1000.0 nm, 95 % interval 998.9 to 1001.1 nm".
     *
     * @param period metres
     * @param low metres
     * @param high metres; infinite where any length is possible
     */
    public static String of(double period, double low, double high) {
        return period(period, low, high) + ", 95 % interval " + interval(low, high);
    }

    /** "998.9 to 1001.1 nm". */
    public static String interval(double low, double high) {
        double uncertainty = uncertainty(low, high);
        return Double.isFinite(high)
                ? number(low, uncertainty) + " to " + number(high, uncertainty) + " nm"
                : number(low, uncertainty) + " nm to any length";
    }

    /** "1000.0 nm". */
    public static String period(double period, double low, double high) {
        return number(period, uncertainty(low, high)) + " nm";
    }

    private static double uncertainty(double low, double high) {
        return Double.isFinite(high) ? 0.5 * (high - low) : 0.5 * low;
    }

    private static String number(double metres, double uncertainty) {
        return Decimals.within(metres * NANOMETRES, uncertainty * NANOMETRES);
    }
}
