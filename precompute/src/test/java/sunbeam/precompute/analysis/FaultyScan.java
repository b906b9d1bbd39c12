package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.prepare.ScanFault;
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

    private static final double SMOOTH = 0.05;

    /** The program's estimate for the measured part of the scan; empty where it refuses. */
    Optional<GratingPeriod> estimate() {
        HeightMap measured = ScanFault.measured(map, ScanFaults.in(map, Optional.empty()));
        return PeriodModel.of(measured, Hypothesis.ANY).filter(GratingPeriod::isSure);
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
            boolean sideways = kind == Kind.SLIPPED || kind == Kind.SLIPPED_OFTEN;
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

    /** Kinds of randomly drawn scans of gratings with known periods. */
    enum Grating {
        CLEAN,
        STRAYED,
        GAPS,
        WARPED,
        NOISY,
        TWO,
        CHIRPED,
        ROWS;

        FaultyScan draw(long seed) {
            SplittableRandom random =
                    new SplittableRandom(seed * 7919 + List.of(values()).indexOf(this));
            double width = 5e-6 * Math.pow(16, random.nextDouble());
            double longest = Math.min(5e-6, width / 4.5);
            double period = 0.6e-6 * Math.pow(longest / 0.6e-6, random.nextDouble());
            double pitch = Math.max(period / (10 + 10 * random.nextDouble()), width / 700);
            int columns = (int) Math.round(width / pitch);
            int rows = Math.max(1, (int) (columns * (0.2 + 0.8 * random.nextDouble())));
            double disorder = 0.15 * random.nextDouble();
            int shape = random.nextInt(3);
            double azimuth = random.nextBoolean() ? 0 : Math.toRadians(-80 + 160 * random.nextDouble());
            double depth = 50e-9 + 200e-9 * random.nextDouble();
            double tilt = random.nextBoolean() ? 0 : 0.2 * (random.nextDouble() - 0.5);
            double noise = this == NOISY ? depth * random.nextDouble() : 0.01 * depth;
            double ratio = 1.08 + 0.4 * random.nextDouble();
            double growth = 1.02 + 0.5 * random.nextDouble();
            double[] lines = lines(random, 3 * (int) Math.ceil(2 * width / period), disorder);
            double start = random.nextDouble();
            int bands = this == ROWS ? Math.max(1, (int) Math.round(rows * pitch / (3 * period))) : 1;
            double[][] bandLines = new double[bands][];
            Arrays.setAll(bandLines, i -> this == ROWS ? GAPS.lines(random, lines.length, disorder) : lines);
            double angle = this == ROWS ? 0 : azimuth;
            HeightMap map = Surfaces.sampled(columns, rows, pitch, (column, row) -> {
                double x = (column - 0.5 * columns) * pitch;
                double y = (0.5 * rows - row) * pitch;
                double s = x * Math.cos(angle) + y * Math.sin(angle);
                double height;
                if (this == TWO) {
                    double other = 0.6 + 0.4 * disorder / 0.15;
                    height = 0.5 * Math.cos(2 * Math.PI * s / period)
                            + 0.5 * other * Math.cos(2 * Math.PI * (s / (period * ratio) + start));
                } else if (this == CHIRPED) {
                    double change = (1 / growth - 1) / width;
                    height = wave(s / period * (1 + 0.5 * change * s) + start, shape);
                } else {
                    height = wave(phase(bandLines[Math.min(bands - 1, row * bands / rows)], s / period) + start, shape);
                }
                return depth * height + tilt * x + noise * random.nextGaussian();
            });
            double[] truths = this == TWO ? new double[] {period, period * ratio} : new double[] {period};
            return new FaultyScan(map, truths, this + " seed " + seed);
        }

        private double[] lines(SplittableRandom random, int count, double disorder) {
            double[] lines = new double[count];
            double walk = 0;
            double velocity = 0;
            for (int i = 0; i < count; i++) {
                double strayed =
                        this == GAPS || this == STRAYED || this == WARPED ? disorder * random.nextGaussian() : 0;
                velocity = this == WARPED ? 0.6 * velocity + 0.4 * strayed : strayed;
                walk = this == STRAYED ? strayed : walk + velocity;
                lines[i] = i - 0.5 * count + walk;
            }
            Arrays.sort(lines);
            return lines;
        }

        /** Number of lines passed, including the part of the current gap. */
        private static double phase(double[] lines, double place) {
            int found = Arrays.binarySearch(lines, place);
            int low = Math.max(0, Math.min(lines.length - 2, found < 0 ? -found - 2 : found));
            return low + (place - lines[low]) / (lines[low + 1] - lines[low]);
        }

        private static double wave(double turns, int shape) {
            double part = turns - Math.floor(turns);
            return switch (shape) {
                case 0 -> 0.5 * Math.cos(2 * Math.PI * part);
                case 1 -> part - 0.5;
                default -> Math.exp(-Math.pow((part - 0.5) / 0.15, 2));
            };
        }
    }
}
