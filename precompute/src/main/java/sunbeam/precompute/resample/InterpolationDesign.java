package sunbeam.precompute.resample;

/**
 * How a Gaussian of the frequency is replaced by a few taps on a grid:
 *
 * <pre>exp(-(f - f_j)^2 / (2 sigma^2)) = sum_m phi(f - m) K(m - f_j),  f in grid steps</pre>
 *
 * phi is a Kaiser-Bessel kernel that the GPU evaluates at a few grid points m around f; K, which spreads the DFT bins onto
 * the grid beforehand, is the Gaussian with phi divided out of its transform. Only aliasing is left as error, and it is
 * small because the Gaussian's transform, the coherence window, has faded where the kernel's has.
 *
 * @param deviation standard deviation of the Gaussian's amplitude in grid steps
 * @param taps grid points that phi reaches along one axis
 * @param beta shape of phi
 * @param error relative root-mean-square error of an amplitude, from the aliases of the kernel
 */
public record InterpolationDesign(double deviation, int taps, double beta, double error) {
    private static final int SPECTRUM_SAMPLES = 512;
    private static final int ALIASES = 6;
    private static final int BETA_CANDIDATES = 96;

    /** The best kernel of a number of taps for a Gaussian of so many grid steps. */
    public static InterpolationDesign best(double deviation, int taps) {
        InterpolationDesign best = null;
        for (int i = 0; i < BETA_CANDIDATES; i++) {
            double beta = taps * (1 + 2.5 * i / BETA_CANDIDATES);
            double error = aliasing(new KaiserBessel(taps, beta), deviation);
            if (best == null || error < best.error) {
                best = new InterpolationDesign(deviation, taps, beta, error);
            }
        }
        return best;
    }

    // Parseval over one period of the grid's spectrum: what the aliases carry, against what the Gaussian carries.
    private static double aliasing(KaiserBessel kernel, double deviation) {
        double aliases = 0;
        double signal = 0;
        for (int i = 0; i <= SPECTRUM_SAMPLES; i++) {
            double frequency = 0.5 * i / SPECTRUM_SAMPLES;
            double gauss = gaussTransform(deviation, frequency);
            double own = kernel.transform(frequency);
            if (own <= 0) {
                return Double.MAX_VALUE;
            }
            for (int n = -ALIASES; n <= ALIASES; n++) {
                if (n != 0) {
                    double alias = gauss / own * kernel.transform(frequency + n);
                    aliases += alias * alias;
                }
            }
            signal += gauss * gauss;
        }
        return Math.sqrt(aliases / signal);
    }

    // Up to a constant factor.
    private static double gaussTransform(double deviation, double frequency) {
        return Math.exp(-0.5 * Math.pow(2 * Math.PI * deviation * frequency, 2));
    }

    /** phi at a distance in grid steps; 0 from taps / 2 on. */
    public double kernel(double distance) {
        return new KaiserBessel(taps, beta).value(distance);
    }

    /** K at a distance in grid steps. */
    double spread(double distance) {
        KaiserBessel phi = new KaiserBessel(taps, beta);
        // The Gaussian's transform is divided by the kernel's up to half a period of the grid, where it has faded.
        int samples = 4 * SPECTRUM_SAMPLES;
        double sum = 0;
        for (int i = 0; i <= samples; i++) {
            double frequency = 0.5 * i / samples;
            double end = i == 0 || i == samples ? 0.5 : 1;
            double value = gaussTransform(deviation, frequency) / phi.transform(frequency);
            sum += end * value * Math.cos(2 * Math.PI * frequency * distance);
        }
        // Both halves of the spectrum, and the height of a Gaussian's transform.
        return 2 * sum * 0.5 / samples * deviation * Math.sqrt(2 * Math.PI);
    }

    /** Distance in grid steps from which on K is taken as zero; what is cut is below the aliases. */
    double spreadReach() {
        return 6.5 * deviation + 0.5 * taps;
    }
}
