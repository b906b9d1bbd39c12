package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A period of a surface and how well a scan tells it.
 *
 * @param period metres
 * @param low of the interval that holds it with a probability of 95 %, metres
 * @param high of that interval, metres
 * @param periods how many fit into the scan along their direction
 * @param second another period beside it, of similar strength and direction, where there is one
 * @param drift where the period changes across the scan: from one end to the other
 * @param slips where the wave jumps from one row to the next: up to {@link #MOST_SLIPS_FOLLOWED}, what is between was followed
 *     by itself; of more, the interval reaches to what is told between them
 * @param doubt why it is no period all the same
 */
public record PeriodEstimate(
        double period,
        double low,
        double high,
        double periods,
        Optional<Second> second,
        Optional<Drift> drift,
        List<Slip> slips,
        Doubt doubt) {

    /** Of a scanner. Where more rows jump, the surface may have lines that know little of each other. */
    public static final int MOST_SLIPS_FOLLOWED = 3;

    /** Why a wave that can be followed is no period of the surface. */
    public enum Doubt {
        /** It is one. */
        NONE,
        /** Chance may have put the lines so ({@link ChanceLines}). */
        CHANCE,
        /** Every second row seems to be shifted by half of the period, of which this is half ({@link HalfShiftedRows}). */
        HALF_SHIFTED,
        /** Waves too fine for light may have left it ({@link FineWaves}). */
        ALIAS,
        /** Rows were levelled one by one, and its lines run along them ({@link LevelledRows}). */
        LEVELLED_ROWS
    }

    public PeriodEstimate {
        slips = List.copyOf(slips);
    }

    /** Of a scan whose rows continue each other. */
    public PeriodEstimate(
            double period, double low, double high, double periods, Optional<Second> second, Optional<Drift> drift) {
        this(period, low, high, periods, second, drift, List.of(), Doubt.NONE);
    }

    /** Of one period, or few, of a surface that repeats without end: known exactly. */
    public static PeriodEstimate exact(double period, double periods) {
        return new PeriodEstimate(period, period, period, periods, Optional.empty(), Optional.empty());
    }

    /**
     * Another period.
     *
     * @param period metres
     * @param low of the interval that holds it with a probability of 95 %, metres
     * @param high of that interval, metres
     * @param strength amplitude over that of the first, 0..1
     */
    public record Second(double period, double low, double high, double strength) {}

    /**
     * A period that changes.
     *
     * @param first metres, at the end where the grating's direction starts
     * @param last metres, at the other
     */
    public record Drift(double first, double last) {
        /** Last over first, or its inverse: 1 or more. */
        public double ratio() {
            return Math.max(first / last, last / first);
        }
    }

    /**
     * A jump of the wave.
     *
     * @param row the first after it, from the top, 0-based
     * @param turns by how many periods, -0.5..0.5: whole ones are not seen
     */
    public record Slip(int row, double turns) {
        String describe() {
            return String.format(
                    Locale.ROOT,
                    "the lines jump sideways by %.2g periods (or as much and whole ones) after row %d from the top, as where the"
                            + " scanner slipped, a line ends, or dust or filled samples lie: the rows above and below were followed by themselves",
                    Math.abs(turns),
                    row);
        }
    }

    /** The same without the second. */
    PeriodEstimate alone() {
        return new PeriodEstimate(period, low, high, periods, Optional.empty(), drift, slips, doubt);
    }

    /** The same of a scan that slipped. */
    PeriodEstimate slippedAt(List<Slip> found) {
        return new PeriodEstimate(period, low, high, periods, second, drift, found, doubt);
    }

    /** The same with an interval that holds those of others that contradict it. */
    PeriodEstimate reaching(List<PeriodEstimate> others) {
        double lowest = low;
        double highest = high;
        for (PeriodEstimate other : others) {
            lowest = contradicts(other) ? Math.min(lowest, other.low) : lowest;
            highest = contradicts(other) ? Math.max(highest, other.high) : highest;
        }
        return within(lowest, highest);
    }

    /** The same that changes from one end of the scan to the other, unless it is known how already. */
    PeriodEstimate drifting(double first, double last) {
        return new PeriodEstimate(
                period, low, high, periods, second, drift.or(() -> Optional.of(new Drift(first, last))), slips, doubt);
    }

    /** The same with another interval. */
    PeriodEstimate within(double lowest, double highest) {
        return new PeriodEstimate(period, lowest, highest, periods, second, drift, slips, doubt);
    }

    /** The same that is no period. */
    PeriodEstimate doubted(Doubt why) {
        return new PeriodEstimate(period, low, high, periods, second, drift, slips, why);
    }

    /** Whether their intervals have nothing in common. */
    boolean contradicts(PeriodEstimate other) {
        return other.low > high || other.high < low;
    }

    /** Whether the scan slipped at so few rows that what is between was followed by itself. */
    public boolean isInPieces() {
        return !slips.isEmpty() && slips.size() <= MOST_SLIPS_FOLLOWED;
    }

    /** Of the slips, for people, without full stops. */
    public List<String> describeSlips() {
        if (slips.isEmpty() || isInPieces()) {
            return slips.stream().map(Slip::describe).toList();
        }
        return List.of(String.format(
                Locale.ROOT,
                "the lines jump sideways at %d rows, the first %d from the top, as where a scanner slips often, lines end, or dust or filled samples lie: the"
                        + " interval reaches to what is told between them",
                slips.size(),
                slips.get(0).row()));
    }

    /** The larger distance from the period to an end of its interval, metres. */
    public double halfWidth() {
        return Math.max(period - low, high - period);
    }
}
