package sunbeam.app.cli;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/**
 * Random pairs of directions and their probability density per solid angles of light and view, 1/sr^2: a mixture of two densities. The
 * background draws both directions in proportion to their cosines. The other chooses a square cell of the (u, v) plane by its weight and
 * draws (u, v) in it. Then it draws the light uniformly from all lights that have a view with this (u, v): the intersection of two unit
 * discs at distance |(u, v)|. Immutable.
 */
final class PairDensity {
    /** Cells along each side of the square |u|, |v| below 2. */
    static final int SIDE = 400;

    static final double BACKGROUND = 0.25;
    // Largest |(u, v)| of any two directions.
    private static final double REACH = 2;
    private static final double STEP = 2 * REACH / SIDE;
    // 2^64 by the golden ratio: modulo 2^64, any number of its multiples is evenly distributed (Kronecker sequence).
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    // Factor from 53 random bits to a number in the unit interval.
    private static final double UNIT = 0x1p-53;

    private final double[] sums = new double[SIDE * SIDE];
    private final long seed;

    /** @param weights weight of each cell within |(u, v)| = 2, not negative; at least one is positive */
    PairDensity(IntToDoubleFunction weights, long seed) {
        this.seed = mixed(seed);
        double sum = 0;
        for (int cell = 0; cell < sums.length; cell++) {
            sum += isInside(cell) ? weights.applyAsDouble(cell) * shared(radius(cell)) : 0;
            sums[cell] = sum;
        }
        double total = sum;
        Arrays.setAll(sums, cell -> sums[cell] / total);
    }

    static double u(int cell) {
        return STEP * (cell % SIDE + 0.5) - REACH;
    }

    static double v(int cell) {
        int row = cell / SIDE;
        return STEP * (row + 0.5) - REACH;
    }

    static double radius(int cell) {
        return Math.hypot(u(cell), v(cell));
    }

    static boolean isInside(int cell) {
        return Math.hypot(Math.abs(u(cell)) + STEP / 2, Math.abs(v(cell)) + STEP / 2) < REACH;
    }

    /** Returns the area of the intersection of two unit discs whose centers are {@code distance} apart. */
    private static double shared(double distance) {
        double half = Math.min(1, distance / 2);
        return 2 * (Math.acos(half) - half * Math.sqrt(1 - half * half));
    }

    /** Draws the pair of a row. Afterwards {@code random}, which must come from {@link #random}, yields further numbers of this row. */
    DirectionPair pair(long row, SplittableRandom random) {
        double stratum = ((mixed(seed) + row * GOLDEN) >>> 11) * UNIT;
        return stratum < BACKGROUND
                ? new DirectionPair(cosine(random), cosine(random))
                : onOrder((stratum - BACKGROUND) / (1 - BACKGROUND), random);
    }

    SplittableRandom random(long row) {
        return new SplittableRandom(mixed(seed ^ mixed(row)));
    }

    private DirectionPair onOrder(double share, SplittableRandom random) {
        int cell = cell(share);
        double u = u(cell) + STEP * (random.nextDouble() - 0.5);
        double v = v(cell) + STEP * (random.nextDouble() - 0.5);
        double radius = Math.hypot(u, v);
        double cosine = radius == 0 ? 1 : u / radius;
        double sine = radius == 0 ? 0 : v / radius;
        double length = 1 - radius / 2;
        double width = Math.sqrt(1 - radius * radius / 4);
        while (true) {
            double along = length * (2 * random.nextDouble() - 1);
            double across = width * (2 * random.nextDouble() - 1);
            if (Math.hypot(Math.abs(along) + radius / 2, across) <= 1) {
                double x = -u / 2 + along * cosine - across * sine;
                double y = -v / 2 + along * sine + across * cosine;
                return new DirectionPair(Direction.ofDisc(x, y), Direction.ofDisc(-u - x, -v - y));
            }
        }
    }

    private int cell(double share) {
        int found = Arrays.binarySearch(sums, share);
        int at = found < 0 ? -found - 1 : found;
        while (sums[at] <= share) {
            at++;
        }
        return at;
    }

    private static Direction cosine(SplittableRandom random) {
        double radius = Math.sqrt(random.nextDouble());
        double phi = 2 * Math.PI * random.nextDouble();
        return Direction.ofDisc(radius * Math.cos(phi), radius * Math.sin(phi));
    }

    /** Returns the probability density of a pair per solid angles, 1/sr^2. */
    double at(DirectionPair pair) {
        double u = pair.u();
        double v = pair.v();
        double orders = 0;
        int column = (int) ((u + REACH) / STEP);
        int row = (int) ((v + REACH) / STEP);
        if (column < SIDE && row < SIDE && isInside(row * SIDE + column)) {
            int cell = row * SIDE + column;
            double probability = sums[cell] - (cell == 0 ? 0 : sums[cell - 1]);
            orders = probability / (STEP * STEP * shared(Math.hypot(u, v)));
        }
        double onDiscs = BACKGROUND / (Math.PI * Math.PI) + (1 - BACKGROUND) * orders;
        return onDiscs * pair.cosThetaI() * pair.cosThetaR();
    }

    /** Mixes bits so that each depends on all (D. Stafford's thirteenth variant of MurmurHash3's finalizer). */
    private static long mixed(long bits) {
        long first = (bits ^ (bits >>> 30)) * 0xbf58476d1ce4e5b9L;
        long second = (first ^ (first >>> 27)) * 0x94d049bb133111ebL;
        return second ^ (second >>> 31);
    }
}
