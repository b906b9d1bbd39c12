package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.prepare.ScanFaults;

/**
 * A randomly drawn scan of a grating, or of a surface without one, with one fault of scanners or of the surface.
 *
 * @param map heights, level by their plane
 * @param truths meters: the period or each of several
 * @param words for messages
 */
record FaultyScan(HeightMap map, double[] truths, String words) {
    enum Kind {
        /** A shift sideways by a part of a period at one row. */
        SLIPPED,
        /** Shifts at five rows, equally far apart and equally large. */
        SLIPPED_OFTEN,
        /** Another period in the lower half, at a random place and by a random ratio. */
        TWO_HALVES,
        SIDE_BY_SIDE,
        /** Lost rows: from one row on the surface continues further on. */
        ROWS_LOST,
        /** Some rows repeat one row, and the surface continues after them. */
        STUCK,
        /** The rest repeats one row. */
        ABORTED,
        CLIPPED
    }

    private static final Set<Kind> SIDEWAYS = EnumSet.of(Kind.SLIPPED, Kind.SLIPPED_OFTEN);
    private static final double SMOOTH = 0.05;

    /** The program's estimate for the measured part of the scan; empty where it refuses. */
    Optional<GratingPeriod> estimate() {
        HeightMap measured = GratingPeriod.measured(map, ScanFaults.in(map, Optional.empty()));
        return PeriodModel.of(measured, wave -> true, GratingPeriod.GLOSS).filter(GratingPeriod::isSure);
    }

    boolean holdsTruth(GratingPeriod estimate) {
        return Arrays.stream(truths).anyMatch(truth -> truth >= estimate.low() && truth <= estimate.high());
    }

    private record Draw(int columns, int rows, double pitch, double period, double angle, int shape) {
        static Draw of(SplittableRandom random) {
            double width = 8e-6 * Math.pow(5, random.nextDouble());
            double period = 0.6e-6 * Math.pow(Math.min(4e-6, width / 7) / 0.6e-6, random.nextDouble());
            double pitch = Math.max(period / (5 + 12 * random.nextDouble()), width / 500);
            int columns = (int) Math.round(width / pitch);
            int rows = (int) (columns * (0.5 + 0.5 * random.nextDouble()));
            double angle = random.nextInt(3) == 0 ? 0 : Math.toRadians(-60 + 120 * random.nextDouble());
            return new Draw(columns, rows, pitch, period, angle, random.nextInt(3));
        }

        /** Height at a phase in turns, 0..1. */
        double at(double x, double y, double further) {
            double turns = (x * Math.cos(angle) + y * Math.sin(angle)) / period + further;
            double part = turns - Math.floor(turns);
            return switch (shape) {
                case 0 -> 0.5 + 0.5 * Math.cos(2 * Math.PI * part);
                case 1 -> part;
                default -> 1 / (1 + Math.exp((Math.abs(part - 0.5) - 0.25) / SMOOTH));
            };
        }
    }

    static FaultyScan draw(Kind kind, long seed) {
        SplittableRandom random = new SplittableRandom(seed * 7919 + kind.name().hashCode());
        Draw draw = Draw.of(random);
        int rows = draw.rows();
        int first = (int) (rows * (0.15 + 0.7 * random.nextDouble()));
        double slip = draw.period() / Math.max(0.3, Math.cos(draw.angle())) * (0.1 + 0.8 * random.nextDouble());
        int length = 3 + random.nextInt(Math.max(4, rows / 6));
        double limit = random.nextBoolean() ? 0.3 + 0.5 * random.nextDouble() : -0.2 - 0.5 * random.nextDouble();
        double noise = 0.03 * random.nextDouble();
        boolean halves = kind == Kind.TWO_HALVES || kind == Kind.SIDE_BY_SIDE;
        double ratio = halves ? 1.05 + 0.2 * random.nextDouble() : 1;
        double place = random.nextDouble();
        double[] heights = new double[draw.columns() * rows];
        for (int row = 0; row < rows; row++) {
            double shift = kind == Kind.SLIPPED_OFTEN ? slip * Math.floor(6.0 * row / rows) : row >= first ? slip : 0;
            int source = switch (kind) {
                case ROWS_LOST -> row >= first ? row + length : row;
                case STUCK -> row >= first && row < first + length ? first : row;
                case ABORTED -> Math.min(row, first);
                default -> row;
            };
            boolean sideways = SIDEWAYS.contains(kind);
            for (int column = 0; column < draw.columns(); column++) {
                boolean other = kind == Kind.SIDE_BY_SIDE ? column >= draw.columns() / 2 : row >= rows / 2;
                double wider = other ? ratio : 1;
                double height = draw.at(
                        column * draw.pitch() / wider + (sideways ? shift : 0),
                        -source * draw.pitch() / wider,
                        halves && other ? place : 0);
                if (kind == Kind.CLIPPED) {
                    height = limit > 0 ? Math.min(height, limit) : Math.max(height, -limit);
                }
                boolean repeats = source != row && (kind == Kind.STUCK || kind == Kind.ABORTED);
                heights[row * draw.columns() + column] = repeats
                        ? heights[(row - 1) * draw.columns() + column]
                        : 1e-7 * (height + noise * random.nextGaussian());
            }
        }
        HeightMap map = new HeightMap(draw.columns(), rows, draw.pitch(), draw.pitch(), heights);
        double[] truths = {draw.period(), ratio * draw.period()};
        return new FaultyScan(Leveling.PLANE.apply(map), truths, kind + " seed " + seed);
    }
}
