package sunbeam.precompute.patch.builtin;

import sunbeam.precompute.optics.HeightMap;

/**
 * Flat bumps of the size of Stam's (Diffraction Shaders, SIGGRAPH 1999), 0.15 um high, 0.5 um along x, 1 um along y, at random
 * places, uniform and independent: shot noise. Where bumps overlap their heights add up. A bump is a whole number of
 * samples wide and lies on samples, round the patch's edge where need be.
 *
 * <p>Its light is known in closed form. Of N bumps of area a on a patch of area A, with t = k w HEIGHT, c = 1 - cos t and g(r)
 * the area that a bump shares with itself shifted by r, the mean over all draws is
 *
 * <pre>
 * mean of p(s) p*(s + r) = (1 - 2 c (a - g(r)) / A)^N
 * </pre>
 *
 * as each bump by itself changes the phase between the two places with the probability 2 (a - g(r)) / A. Beyond a bump's
 * size g is 0 and this a constant, the light in mirror direction. The rest, transformed, is the halo, of sparse bumps the light
 * of one bump times their number, N (2 a sin(t / 2) sinc(fx 0.5 um) sinc(fy 1 um))^2 / A.
 */
final class RandomBumps {
    /** Of a bump, meters. */
    static final double HEIGHT = 150e-9;

    static final double PITCH = 62.5e-9;
    /** Of a bump along x, samples. */
    static final int COLUMNS = 8;
    /** Of a bump along y, samples. */
    static final int ROWS = 16;

    private static final int SAMPLES = 1024;
    /** Their areas add up to an eighth of the patch's. */
    private static final int BUMPS = 1024;

    private static final int SEED = 5;

    private RandomBumps() {}

    /** The built-in patch, 64 um along each side. */
    static HeightMap generate() {
        return generate(SAMPLES, BUMPS, SEED);
    }

    /** @param samples along each side, at least one bump's */
    static HeightMap generate(int samples, int bumps, long seed) {
        SeededNoise noise = new SeededNoise(seed);
        double[] heights = new double[samples * samples];
        for (int bump = 0; bump < bumps; bump++) {
            int left = (int) (noise.uniform() * samples);
            int top = (int) (noise.uniform() * samples);
            for (int i = 0; i < ROWS * COLUMNS; i++) {
                heights[(top + i / COLUMNS) % samples * samples + (left + i % COLUMNS) % samples] += HEIGHT;
            }
        }
        return HeightMap.owning(samples, samples, PITCH, PITCH, heights);
    }
}
