package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.optics.HeightMap;

/**
 * A randomly drawn scan whose order is known.
 *
 * @param map raw heights, meters
 * @param periods those a verdict may tell, meters; none for a surface without order
 * @param clear whether a person who looks at the heights sees the order
 */
record KnownSurface(Kind kind, HeightMap map, double[] periods, boolean clear, String words) {
    private static final double UM = 1e-6;
    private static final double NM = 1e-9;

    enum Truth {
        GRATING,
        LATTICE,
        RING,
        NONE,
        /** A wave that fits fewer than three times. */
        FEW
    }

    enum Kind {
        LINES(Truth.GRATING),
        PARTLY_COVERED(Truth.GRATING),
        LATTICE(Truth.LATTICE),
        RING(Truth.RING),
        FRACTAL(Truth.NONE),
        ROUGH(Truth.NONE),
        BRUSHED(Truth.NONE),
        TERRACES(Truth.NONE),
        BUMPS(Truth.NONE),
        /** Tracks of pits of random lengths, as on a compact disc. */
        TRACKS(Truth.GRATING),
        /** Pits along parallel tracks at random distances. */
        RANDOM_PITS(Truth.NONE),
        /** Every second or third line is lower: the period is two or three distances of lines. */
        UNLIKE_LINES(Truth.GRATING),
        /** Pairs of lines, each off its place by a part of the period. */
        PITCH_WALKING(Truth.GRATING),
        /** Steep lines under a round tip: the heights are dilated. */
        BLUNT_TIP(Truth.GRATING),
        /** The lower part was not measured and repeats one row. */
        STOPPED(Truth.GRATING),
        /** Two gratings side by side. */
        DOMAINS(Truth.GRATING),
        CRACKED(Truth.GRATING),
        /** Grains with lines of one distance in many directions. */
        GRAINS(Truth.RING),
        /** A wave along the rows that starts each row at a random phase. */
        VIBRATION(Truth.NONE),
        /** Edges of terraces, straight or curved, or a scratch, several times as high as the lines. */
        EDGES(Truth.GRATING),
        /** A sine with hardly any noise that fits 1.3 to 2.95 times. */
        FEW_PERIODS(Truth.FEW);

        final Truth truth;

        Kind(Truth truth) {
            this.truth = truth;
        }
    }

    enum Defect {
        DUST,
        RIDGE,
        BLOCK,
        JUMP,
        ROW_OFFSETS,
        BOW,
        DRIFT,
        SCRATCHES,
        SPIKES
    }

    /** @param seed for one kind, another seed is another surface */
    static KnownSurface draw(Kind kind, long seed) {
        return new Draft(new SplittableRandom(1000003 * seed + kind.name().hashCode())).draw(kind);
    }

    /** The scan's samples while they are drawn; x to the right, y upwards, meters. */
    private static final class Draft {
        // Samples along each axis of the noise, at least those of a scan; a power of two.
        private static final int GRID = 256;

        private final SplittableRandom random;
        private final int columns;
        private final int rows;
        private final double pitch;
        private final double[] heights;
        private double amplitude;

        Draft(SplittableRandom random) {
            this.random = random;
            columns = 128 + 64 * random.nextInt(3);
            rows = (int) (columns * (random.nextBoolean() ? 1 : 0.75));
            pitch = between(8, 40) * UM / columns;
            heights = new double[columns * rows];
        }

        double between(double low, double high) {
            return low + (high - low) * random.nextDouble();
        }

        double x(int i) {
            return (i % columns + 0.5) * pitch;
        }

        double y(int i) {
            return (rows - i / columns - 0.5) * pitch;
        }

        double side() {
            return pitch * Math.min(columns, rows);
        }

        void add(IntToDoubleFunction height) {
            for (int i = 0; i < heights.length; i++) {
                heights[i] += height.applyAsDouble(i);
            }
        }

        /** Position across lines whose normal is at an angle to +x, from the center. */
        double across(int i, double angle) {
            return (x(i) - 0.5 * columns * pitch) * Math.cos(angle) + (y(i) - 0.5 * rows * pitch) * Math.sin(angle);
        }

        KnownSurface draw(Kind kind) {
            amplitude = between(10, 120) * NM;
            double fewest = 4.5;
            double period = Math.exp(between(Math.log(Math.max(0.5 * UM, 7 * pitch)), Math.log(side() / fewest)));
            double angle = between(-0.5, 0.5) * Math.PI;
            double jitter = random.nextBoolean() ? 0 : between(0, 0.05);
            double[] truths = {period};
            switch (kind) {
                case LINES, STOPPED, CRACKED -> add(grating(period, angle, jitter, profile()));
                case PARTLY_COVERED -> {
                    double part = between(0.45, 0.8) * columns * pitch;
                    IntToDoubleFunction lines = grating(period, angle, jitter, profile());
                    add(i -> x(i) < part ? lines.applyAsDouble(i) : 0);
                }
                case LATTICE -> {
                    int count = 2 + random.nextInt(2);
                    double part = Math.min(period, side() / 6);
                    truths = new double[] {part};
                    for (int k = 0; k < count; k++) {
                        double turn = angle + k * Math.PI / count;
                        double phase = between(0, 1);
                        add(i -> amplitude / count * Math.cos(2 * Math.PI * (across(i, turn) / part + phase)));
                    }
                }
                case RING -> {
                    period = Math.min(period, side() / 8);
                    truths = new double[] {period};
                    double one = period;
                    waves(150, amplitude, () -> {
                        double turns = (1 + 0.08 * random.nextGaussian()) / one;
                        double direction = between(0, Math.PI);
                        return new double[] {turns * Math.cos(direction), turns * Math.sin(direction)};
                    });
                }
                case GRAINS -> {
                    period = Math.min(period, side() / 14);
                    truths = new double[] {period};
                    grains(period);
                }
                case UNLIKE_LINES -> {
                    int many = 2 + random.nextInt(2);
                    period = Math.max(7 * pitch, Math.min(period, side() / (6 * many)));
                    truths = new double[] {many * period};
                    double lower = between(0.25, 0.7);
                    DoubleUnaryOperator line = profile();
                    add(grating(
                            many * period,
                            angle,
                            jitter / many,
                            turns -> (1 + line.applyAsDouble(many * turns - Math.floor(many * turns)))
                                            * (many * turns < 1 ? 1 - lower : 1)
                                    - 1));
                }
                case PITCH_WALKING -> {
                    period = Math.max(7 * pitch, Math.min(period, side() / 12));
                    truths = new double[] {2 * period};
                    double off = between(0.06, 0.15);
                    add(grating(
                            2 * period,
                            angle,
                            jitter / 2,
                            turns -> Math.abs(turns - 0.25 - off) < 0.125 || Math.abs(turns - 0.75) < 0.125 ? 1 : -1));
                }
                case BLUNT_TIP -> {
                    add(grating(period, angle, jitter, turns -> turns < 0.4 ? 1 : -1));
                    dilate(between(0.1, 0.3) * period);
                }
                case DOMAINS -> {
                    double part = Math.max(7 * pitch, Math.min(period, side() / 9));
                    double other = part * between(1.2, 1.7);
                    truths = new double[] {part, other};
                    double border = between(0.4, 0.6) * columns * pitch;
                    IntToDoubleFunction left = grating(part, angle, 0, profile());
                    IntToDoubleFunction right = grating(other, between(-0.5, 0.5) * Math.PI, 0, profile());
                    add(i -> (x(i) < border ? left : right).applyAsDouble(i));
                }
                case TRACKS -> {
                    period = side() / between(4.5, 9);
                    truths = new double[] {period};
                    pits(angle, period, 0);
                }
                case RANDOM_PITS -> pits(angle, side() / between(4, 9), 0.5);
                case VIBRATION -> vibrate(period);
                case EDGES -> {
                    amplitude = between(40, 80) * NM;
                    add(grating(period, angle, 0, profile()));
                    terraces();
                }
                case FEW_PERIODS -> {
                    double longest = pitch * (columns * Math.abs(Math.cos(angle)) + rows * Math.abs(Math.sin(angle)));
                    period = longest / between(1.3, 2.95);
                    truths = new double[] {period};
                    add(grating(period, angle, 0, turns -> Math.sin(2 * Math.PI * turns)));
                }
                default -> noise(kind);
            }
            boolean pure = kind == Kind.EDGES || kind == Kind.FEW_PERIODS;
            double rough = pure || kind == Kind.TRACKS || kind == Kind.RANDOM_PITS ? 0.05 : between(0.03, 0.3);
            noise(rough * amplitude, between(0.3, 5) * UM, between(1, 4));
            if (kind == Kind.CRACKED) {
                crack();
            }
            StringBuilder words = new StringBuilder();
            int count = kind.compareTo(Kind.BUMPS) <= 0 ? random.nextInt(4) : pure ? 0 : random.nextInt(2);
            List<Defect> left = new ArrayList<>(List.of(Defect.values()));
            for (int k = 0; k < count; k++) {
                Defect defect = left.remove(random.nextInt(left.size()));
                words.append(' ').append(defect);
                spoil(defect);
            }
            if (kind == Kind.STOPPED) {
                int first = (int) (rows * between(0.5, 0.8));
                for (int i = first * columns; i < heights.length; i++) {
                    heights[i] = heights[i - columns];
                }
            }
            boolean order = kind.truth == Truth.GRATING || kind.truth == Truth.LATTICE || kind.truth == Truth.FEW;
            double seen = side() / truths[0] * (kind == Kind.STOPPED ? 0.5 : 1);
            String about = order
                    ? String.format(
                            " %.3f um, %.1f periods, jitter %.3f, %.0f deg",
                            truths[0] / UM, seen, jitter, Math.toDegrees(angle))
                    : "";
            return new KnownSurface(
                    kind,
                    new HeightMap(columns, rows, pitch, pitch, heights),
                    kind.truth == Truth.NONE ? new double[0] : truths,
                    order && seen >= 4 && kind.truth != Truth.FEW,
                    kind + words.toString() + about);
        }

        /** Height -1..1 by the part of a period 0..1. */
        private DoubleUnaryOperator profile() {
            double duty = between(0.25, 0.75);
            return switch (random.nextInt(4)) {
                case 0 -> turns -> Math.sin(2 * Math.PI * turns);
                case 1 -> turns -> turns < duty ? 1 : -1;
                case 2 -> turns -> 2 * turns - 1;
                default -> turns -> 2 * Math.abs(Math.sin(Math.PI * turns)) - 1;
            };
        }

        /** @param jitter standard deviation of the lines' places, periods */
        private IntToDoubleFunction grating(double period, double angle, double jitter, DoubleUnaryOperator profile) {
            int reach = (int) (pitch * (columns + rows) / period) + 4;
            double[] edges = new double[2 * reach];
            double walk = 0;
            for (int k = 0; k < edges.length; k++) {
                walk += 0.5 * jitter * random.nextGaussian();
                edges[k] = k - reach + walk + 0.5 * jitter * random.nextGaussian();
            }
            Arrays.sort(edges);
            double phase = between(0, 1);
            return i -> {
                double turns = across(i, angle) / period + phase;
                int found = Arrays.binarySearch(edges, turns);
                int low = Math.max(0, Math.min(edges.length - 2, found < 0 ? -found - 2 : found));
                double part = (turns - edges[low]) / (edges[low + 1] - edges[low]);
                return amplitude * profile.applyAsDouble(part - Math.floor(part));
            };
        }

        private void waves(int count, double rms, Supplier<double[]> frequencies) {
            double scale = rms * Math.sqrt(2.0 / count);
            for (int k = 0; k < count; k++) {
                double[] wave = frequencies.get();
                double size = wave.length > 2 ? wave[2] : 1;
                double phase = between(0, 2 * Math.PI);
                double stepX = 2 * Math.PI * wave[0] * pitch;
                double stepY = -2 * Math.PI * wave[1] * pitch;
                for (int row = 0, i = 0; row < rows; row++) {
                    // A rotation by one column's step, from the row's exact phase.
                    double re = scale * size * Math.cos(phase + stepY * row);
                    double im = scale * size * Math.sin(phase + stepY * row);
                    double cosine = Math.cos(stepX);
                    double sine = Math.sin(stepX);
                    for (int column = 0; column < columns; column++, i++) {
                        heights[i] += re;
                        double next = re * cosine - im * sine;
                        im = re * sine + im * cosine;
                        re = next;
                    }
                }
            }
        }

        /** Isotropic noise whose power falls, beyond a longest wave in meters, with the frequency to the power -slope. */
        private void noise(double rms, double longest, double slope) {
            Complex[][] waves = new Complex[GRID][GRID];
            for (int y = 0; y < GRID; y++) {
                for (int x = 0; x < GRID; x++) {
                    double turns = Math.hypot(Math.min(x, GRID - x), Math.min(y, GRID - y)) / (GRID * pitch);
                    double size = x + y == 0 ? 0 : Math.pow(1 + Math.pow(turns * longest, 2), -0.25 * slope);
                    waves[y][x] = new Complex(size * random.nextGaussian(), size * random.nextGaussian());
                }
            }
            Complex[][] field = transformed(transformed(waves));
            double[] drawn = new double[heights.length];
            Arrays.setAll(drawn, i -> field[i / columns][i % columns].getReal());
            double scale = rms / Math.sqrt(StatUtils.populationVariance(drawn));
            add(i -> scale * drawn[i]);
        }

        /** Transforms the rows and exchanges rows and columns. */
        private static Complex[][] transformed(Complex[][] rows) {
            FastFourierTransformer transformer = new FastFourierTransformer(DftNormalization.STANDARD);
            Complex[][] result = new Complex[GRID][GRID];
            for (int y = 0; y < GRID; y++) {
                Complex[] line = transformer.transform(rows[y], TransformType.FORWARD);
                for (int x = 0; x < GRID; x++) {
                    result[x][y] = line[x];
                }
            }
            return result;
        }

        private void noise(Kind kind) {
            double angle = between(0, Math.PI);
            switch (kind) {
                case FRACTAL -> noise(amplitude, columns * pitch, between(2, 5));
                case ROUGH -> noise(amplitude, between(0.2, 3) * UM, 6);
                case BRUSHED -> {
                    double step = between(0.1, 0.8) * UM;
                    double[] knots = random.doubles(2 * (int) (pitch * (columns + rows) / step) + 4, -1, 1)
                            .toArray();
                    add(i -> {
                        double place = 0.5 * knots.length + across(i, angle) / step;
                        int low = (int) place;
                        return 2 * amplitude * (knots[low] + (place - low) * (knots[low + 1] - knots[low]));
                    });
                }
                case TERRACES -> {
                    noise(1, 8 * UM, 4);
                    double step = amplitude;
                    Arrays.setAll(heights, i -> step * Math.floor(2 * heights[i]));
                }
                default -> {
                    for (int k = 20 + random.nextInt(180); k > 0; k--) {
                        bump(amplitude, 0.3 * UM);
                    }
                }
            }
        }

        private void bump(double height, double sigma) {
            double left = between(0, columns * pitch);
            double bottom = between(0, rows * pitch);
            add(i -> height * Math.exp(-(Math.pow(x(i) - left, 2) + Math.pow(y(i) - bottom, 2)) / (2 * sigma * sigma)));
        }

        /** @param disorder of the tracks' distances, relative */
        private void pits(double angle, double distance, double disorder) {
            double width = 0.35 * distance;
            int count = (int) (pitch * (columns + rows) / distance) + 3;
            double reach = pitch * (columns + rows);
            for (int k = -count; k <= count; k++) {
                double center = distance * (k + disorder * 2 * between(-0.5, 0.5));
                for (double start = -reach; start < reach; ) {
                    double end = start + distance * between(0.5, 2);
                    double from = start;
                    add(i -> {
                        double along = across(i, angle + 0.5 * Math.PI);
                        boolean inside =
                                Math.abs(across(i, angle) - center) < 0.5 * width && along > from && along < end;
                        return inside ? -amplitude : 0;
                    });
                    start = end + distance * between(0.5, 2);
                }
            }
        }

        private void grains(double period) {
            int count = 25;
            double[] left = random.doubles(count, 0, columns * pitch).toArray();
            double[] bottom = random.doubles(count, 0, rows * pitch).toArray();
            double[] turns = random.doubles(count, 0, Math.PI).toArray();
            double[] phases = random.doubles(count, 0, 1).toArray();
            add(i -> {
                int nearest = IntStream.range(0, count)
                        .boxed()
                        .min(Comparator.comparingDouble(k -> Math.hypot(x(i) - left[k], y(i) - bottom[k])))
                        .orElseThrow();
                return amplitude * Math.sin(2 * Math.PI * (across(i, turns[nearest]) / period + phases[nearest]));
            });
        }

        private void vibrate(double period) {
            double[] phases = random.doubles(rows, 0, 1).toArray();
            add(i -> amplitude * Math.sin(2 * Math.PI * (x(i) / period + phases[i / columns])));
        }

        private void dilate(double radius) {
            double[] before = heights.clone();
            int reach = (int) (radius / pitch);
            double tip = 0.5 * amplitude;
            for (int i = 0; i < heights.length; i++) {
                double highest = before[i];
                for (int row = Math.max(0, i / columns - reach);
                        row <= Math.min(rows - 1, i / columns + reach);
                        row++) {
                    for (int column = Math.max(0, i % columns - reach);
                            column <= Math.min(columns - 1, i % columns + reach);
                            column++) {
                        double distance = pitch * Math.hypot(row - i / columns, column - i % columns);
                        highest = Math.max(
                                highest,
                                before[row * columns + column] - tip * distance * distance / (radius * radius));
                    }
                }
                heights[i] = highest;
            }
        }

        /** One or two edges of terraces, an island, or a scratch across the scan; edges are up to 0.3 um wide. */
        private void terraces() {
            int form = random.nextInt(5);
            double width = random.nextBoolean() ? 1e-3 * pitch : between(0, 0.15) * UM;
            for (int k = form == 1 ? 2 : 1; k > 0; k--) {
                double height = between(300, 500) * NM * (random.nextBoolean() ? 1 : -1);
                double angle = between(-0.5, 0.5) * Math.PI;
                double offset = between(-0.3, 0.3) * side();
                double radius = between(0.15, 0.35) * side();
                double bend = form == 2 ? between(0.1, 0.3) / side() : 0;
                add(i -> {
                    double along = across(i, angle + 0.5 * Math.PI);
                    double beyond = across(i, angle) - offset + bend * along * along;
                    double inside = radius - Math.hypot(across(i, angle) - offset, along);
                    double place = form == 3 ? inside : form == 4 ? 2 * pitch - Math.abs(beyond) : beyond;
                    return 0.5 * height * Math.tanh(place / width);
                });
            }
        }

        private void crack() {
            for (int k = 1 + random.nextInt(4); k > 0; k--) {
                double angle = between(0, Math.PI);
                double offset = between(-0.4, 0.4) * side();
                double wobble = between(0, 0.1) * side();
                double depth = between(1, 4) * amplitude;
                add(i -> Math.abs(across(i, angle)
                                        - offset
                                        - wobble * Math.sin(6 * across(i, angle + 0.5 * Math.PI) / side()))
                                < 2.5 * pitch
                        ? -depth
                        : 0);
            }
        }

        private void spoil(Defect defect) {
            double big = between(100, 600) * NM;
            double angle = between(0, Math.PI);
            int first = 8 + random.nextInt(rows - 16);
            switch (defect) {
                case DUST -> {
                    for (int k = 1 + random.nextInt(5); k > 0; k--) {
                        bump(big, between(0.2, 0.8) * UM);
                    }
                }
                case RIDGE -> {
                    double offset = between(-0.4, 0.4) * side();
                    double width = between(0.4, 2) * UM;
                    add(i -> big * Math.exp(-Math.pow((across(i, angle) - offset) / width, 2)));
                }
                case BLOCK -> {
                    int end = first + 4 + random.nextInt(rows / 4);
                    double shift = random.nextBoolean() ? big : -big;
                    add(i -> i / columns >= first && i / columns < end ? shift : 0);
                }
                case JUMP -> add(i -> i / columns >= first ? big : 0);
                case ROW_OFFSETS -> {
                    double[] offsets = new double[rows];
                    double size = between(0.05, 0.5) * amplitude;
                    Arrays.setAll(offsets, row -> size * random.nextGaussian());
                    add(i -> offsets[i / columns]);
                }
                case BOW -> {
                    double top = between(0.2, 0.8);
                    add(i -> 3
                            * big
                            * (Math.pow(x(i) / (columns * pitch) - top, 2) + Math.pow(y(i) / (rows * pitch) - 0.5, 2)));
                }
                case DRIFT -> {
                    double[] offsets = new double[rows];
                    Arrays.setAll(
                            offsets, row -> (row > 0 ? offsets[row - 1] : 0) + 0.1 * amplitude * random.nextGaussian());
                    add(i -> offsets[i / columns]);
                }
                case SCRATCHES -> {
                    for (int k = 1 + random.nextInt(4); k > 0; k--) {
                        double turn = between(0, Math.PI);
                        double offset = between(-0.5, 0.5) * side();
                        double width = between(0.1, 0.3) * UM;
                        add(i -> -0.5 * big * Math.exp(-Math.pow((across(i, turn) - offset) / width, 2)));
                    }
                }
                case SPIKES -> {
                    for (int k = 1 + random.nextInt(20); k > 0; k--) {
                        heights[random.nextInt(heights.length)] += 2 * big;
                    }
                }
            }
        }
    }
}
