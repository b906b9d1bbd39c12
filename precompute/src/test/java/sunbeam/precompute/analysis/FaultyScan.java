package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.prepare.ScanFaults;

/**
 * A randomly drawn scan of a grating, or of a surface without one, with one fault of scanners or of the surface.
 *
 * @param map heights, level by their plane
 * @param truths meters: the period or each of several; of terraces their mean width
 * @param anyBetween whether what lies between them is as true
 * @param words for messages
 */
record FaultyScan(HeightMap map, double[] truths, boolean anyBetween, String words) {
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
        /** A line ends in the middle. */
        DISLOCATED,
        CLIPPED,
        /** Two crossed waves with periods within a third. */
        LATTICE,
        /** Bumps on a hexagonal lattice. */
        HEXAGONS,
        /** Steps of equal height with hard edges, their widths within a factor of five. */
        TERRACES,
        /** Two or three waves of one period, mirrored about the rows. */
        ALIGNED
    }

    private static final Set<Kind> SIDEWAYS = EnumSet.of(Kind.SLIPPED, Kind.SLIPPED_OFTEN);
    private static final double SMOOTH = 0.05;

    /** The program's estimate for the measured part of the scan; empty where it refuses. */
    Optional<GratingPeriod> estimate() {
        HeightMap measured = GratingPeriod.measured(map, ScanFaults.in(map, Optional.empty()));
        return PeriodModel.of(measured, wave -> true, GratingPeriod.GLOSS).filter(GratingPeriod::isSure);
    }

    boolean holdsTruth(GratingPeriod estimate) {
        if (anyBetween) {
            return estimate.low() <= Arrays.stream(truths).max().orElseThrow()
                    && estimate.high() >= Arrays.stream(truths).min().orElseThrow();
        }
        return Arrays.stream(truths).anyMatch(truth -> truth >= estimate.low() && truth <= estimate.high());
    }

    private record Draw(
            Kind kind,
            SplittableRandom random,
            int columns,
            int rows,
            double pitch,
            double period,
            double angle,
            int shape) {
        static Draw of(Kind kind, SplittableRandom random) {
            double width = 8e-6 * Math.pow(5, random.nextDouble());
            double period = 0.6e-6 * Math.pow(Math.min(4e-6, width / 7) / 0.6e-6, random.nextDouble());
            double pitch = Math.max(period / (5 + 12 * random.nextDouble()), width / 500);
            int columns = (int) Math.round(width / pitch);
            int rows = (int) (columns * (0.5 + 0.5 * random.nextDouble()));
            double angle = random.nextInt(3) == 0 ? 0 : Math.toRadians(-60 + 120 * random.nextDouble());
            return new Draw(kind, random, columns, rows, pitch, period, angle, random.nextInt(3));
        }

        /** Periods across the scan that differ by up to half a line. */
        double[] withHalfALine() {
            double half = 0.5 / (columns * pitch);
            return new double[] {
                1 / Math.hypot(Math.cos(angle) / period + half, Math.sin(angle) / period),
                1 / Math.hypot(Math.cos(angle) / period - half, Math.sin(angle) / period)
            };
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
        return switch (kind) {
            case LATTICE, HEXAGONS, ALIGNED -> lattice(kind, seed, random);
            case TERRACES -> terraces(seed, random);
            default -> faulty(Draw.of(kind, random), seed);
        };
    }

    private static FaultyScan faulty(Draw draw, long seed) {
        SplittableRandom random = draw.random();
        int rows = draw.rows();
        int first = (int) (rows * (0.15 + 0.7 * random.nextDouble()));
        double slip = draw.period() / Math.max(0.3, Math.cos(draw.angle())) * (0.1 + 0.8 * random.nextDouble());
        int length = 3 + random.nextInt(Math.max(4, rows / 6));
        double limit = random.nextBoolean() ? 0.3 + 0.5 * random.nextDouble() : -0.2 - 0.5 * random.nextDouble();
        double noise = 0.03 * random.nextDouble();
        boolean halves = draw.kind() == Kind.TWO_HALVES || draw.kind() == Kind.SIDE_BY_SIDE;
        double ratio = halves ? 1.05 + 0.2 * random.nextDouble() : 1;
        double place = random.nextDouble();
        double[] heights = new double[draw.columns() * rows];
        for (int row = 0; row < rows; row++) {
            double shift =
                    draw.kind() == Kind.SLIPPED_OFTEN ? slip * Math.floor(6.0 * row / rows) : row >= first ? slip : 0;
            int source = switch (draw.kind()) {
                case ROWS_LOST -> row >= first ? row + length : row;
                case STUCK -> row >= first && row < first + length ? first : row;
                case ABORTED -> Math.min(row, first);
                default -> row;
            };
            boolean sideways = SIDEWAYS.contains(draw.kind());
            for (int column = 0; column < draw.columns(); column++) {
                boolean other = draw.kind() == Kind.SIDE_BY_SIDE ? column >= draw.columns() / 2 : row >= rows / 2;
                double wider = other ? ratio : 1;
                double further = draw.kind() == Kind.DISLOCATED
                        ? Math.atan2(row - first + 0.5, column - (0.3 + 0.4 * place) * draw.columns()) / (2 * Math.PI)
                        : halves && other ? place : 0;
                double height = draw.at(
                        column * draw.pitch() / wider + (sideways ? shift : 0),
                        -source * draw.pitch() / wider,
                        further);
                if (draw.kind() == Kind.CLIPPED) {
                    height = limit > 0 ? Math.min(height, limit) : Math.max(height, -limit);
                }
                boolean repeats = source != row && (draw.kind() == Kind.STUCK || draw.kind() == Kind.ABORTED);
                heights[row * draw.columns() + column] = repeats
                        ? heights[(row - 1) * draw.columns() + column]
                        : 1e-7 * (height + noise * random.nextGaussian());
            }
        }
        String words = draw.kind() + " seed " + seed;
        HeightMap map = new HeightMap(draw.columns(), rows, draw.pitch(), draw.pitch(), heights);
        if (draw.kind() == Kind.DISLOCATED) {
            // One side of its end has a line more.
            return new FaultyScan(Leveling.PLANE.apply(map), draw.withHalfALine(), true, words);
        }
        return scan(map, new double[] {draw.period(), ratio * draw.period()}, words);
    }

    private static FaultyScan scan(HeightMap map, double[] truths, String words) {
        return new FaultyScan(Leveling.PLANE.apply(map), truths, false, words);
    }

    private static FaultyScan lattice(Kind kind, long seed, SplittableRandom random) {
        Draw draw = Draw.of(kind, random);
        boolean hexagons = kind == Kind.HEXAGONS || (kind == Kind.ALIGNED && random.nextBoolean());
        double between = Math.toRadians(hexagons ? 60 : 30 + 60 * random.nextDouble());
        double ratio = kind == Kind.LATTICE ? 1 + 0.3 * random.nextDouble() : 1;
        int waves = hexagons ? 3 : 2;
        double noise = 0.03 * random.nextDouble();
        double start = kind == Kind.ALIGNED
                ? -0.5 * between + (random.nextBoolean() ? 0 : 0.5 * Math.PI)
                : Math.toRadians(180 * random.nextDouble());
        double[] truths = IntStream.range(0, waves)
                .mapToDouble(i -> draw.period() * Math.pow(ratio, i))
                .toArray();
        HeightMap map = Surfaces.sampled(draw.columns(), draw.rows(), draw.pitch(), (column, row) -> {
            double height = noise * random.nextGaussian();
            for (int i = 0; i < waves; i++) {
                double angle = start + i * between;
                double along = column * Math.cos(angle) - row * Math.sin(angle);
                height += Math.cos(2 * Math.PI * draw.pitch() * along / truths[i]);
            }
            return 1e-7 * height;
        });
        return scan(map, truths, kind + " seed " + seed);
    }

    private static FaultyScan terraces(long seed, SplittableRandom random) {
        int columns = 128 + random.nextInt(385);
        int rows = 128 + random.nextInt(385);
        double pitch = 10e-9 * Math.pow(10, random.nextDouble());
        double angle = random.nextInt(4) == 0 ? 0 : random.nextDouble() * 2 * Math.PI;
        int count = 3 + random.nextInt(20);
        boolean up = random.nextInt(3) > 0;
        double noise = random.nextBoolean() ? 0 : 0.03 * random.nextDouble();
        double diagonal = Math.hypot(columns, rows);
        double[] edges = random.doubles(count, 1, 5).toArray();
        Arrays.parallelPrefix(edges, Double::sum);
        double scale = diagonal / edges[count - 1];
        HeightMap map = Surfaces.sampled(columns, rows, pitch, (column, row) -> {
            double x = column - 0.5 * columns;
            double place = x * Math.cos(angle) + (row - 0.5 * rows) * Math.sin(angle) + 0.5 * diagonal;
            long step =
                    Arrays.stream(edges).filter(edge -> edge * scale < place).count();
            return 1e-8 * ((up ? step : step % 2) + noise * random.nextGaussian());
        });
        // A period that is found is one terrace wide, or two where every other one lies higher.
        double width = diagonal / count * pitch;
        return scan(map, new double[] {width, 2 * width}, Kind.TERRACES + " seed " + seed);
    }
}
