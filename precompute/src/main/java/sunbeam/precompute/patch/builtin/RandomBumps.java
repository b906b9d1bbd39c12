package sunbeam.precompute.patch.builtin;

import sunbeam.precompute.optics.HeightMap;

/**
 * Flat bumps of the size that Stam chose (Diffraction Shaders, SIGGRAPH 1999), 0.15 um high, 0.5 um along x, 1 um along y, at independent,
 * uniformly random positions (shot noise). Heights of overlapping bumps add up. Bumps align with samples and wrap around the patch's edge.
 *
 * <p>Let p(s) = exp(i k w h(s)) be the phase factor, t = k w HEIGHT, c = 1 - cos t. Let N be the number of bumps of area a on a patch of
 * area A, and g(r) the area of the intersection of a bump with itself shifted by r. The expected autocorrelation of p is
 *
 * <pre>mean of p(s) p*(s + r) = (1 - 2 c (a - g(r)) / A)^N</pre>
 *
 * because each bump changes the phase between the two positions with the probability 2 (a - g(r)) / A. For r beyond a bump's size, g is 0
 * and the autocorrelation constant: this is the light in the mirror direction. The Fourier transform of the rest is the halo. For sparse
 * bumps it is the power of one bump times their number, N (2 a sin(t / 2) sinc(fx 0.5 um) sinc(fy 1 um))^2 / A.
 */
final class RandomBumps {
    static final double HEIGHT = 150e-9;

    static final double PITCH = 62.5e-9;
    static final int COLUMNS = 8;

    static final int ROWS = 16;

    private static final int SAMPLES = 1024;
    /** Their areas add up to an eighth of the patch's. */
    private static final int BUMPS = 1024;

    private static final int SEED = 5;

    private RandomBumps() {}

    static HeightMap generate() {
        return generate(SAMPLES, BUMPS, SEED);
    }

    /** @param samples samples per side, at least {@link #ROWS} */
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
        return new HeightMap(samples, samples, PITCH, PITCH, heights);
    }
}
