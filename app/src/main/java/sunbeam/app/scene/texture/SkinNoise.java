package sunbeam.app.scene.texture;

/** Smooth noise between -1 and 1 over the body, seamless at the belly, of independent values along and around it. */
record SkinNoise(int seed, int cellsAlong, int cellsAround) {
    /** Along the body from 0 to 1, around it from -1 to 1. */
    double at(double along, double around) {
        double x = along * cellsAlong;
        double y = 0.5 * (around + 1) * cellsAround;
        // A cast equals the floor of numbers from 0 on, and is faster.
        int left = (int) x;
        int below = (int) y;
        double fx = smooth(x - left);
        double fy = smooth(y - below);
        double low = value(left, below) * (1 - fx) + value(left + 1, below) * fx;
        double high = value(left, below + 1) * (1 - fx) + value(left + 1, below + 1) * fx;
        return low * (1 - fy) + high * fy;
    }

    private static double smooth(double t) {
        return t * t * (3 - 2 * t);
    }

    private double value(int column, int row) {
        return hash(seed + 0x9e3779b9 * column + 0x85ebca6b * Math.floorMod(row, cellsAround));
    }

    /** Pseudorandom from -1 to 1: the finalizer of MurmurHash3 (A. Appleby) spreads neighbors over all 32 bits. */
    static double hash(int number) {
        int h = (number ^ number >>> 16) * 0x85ebca6b;
        h = (h ^ h >>> 13) * 0xc2b2ae35;
        return (h ^ h >>> 16) / 2147483648.0;
    }
}
