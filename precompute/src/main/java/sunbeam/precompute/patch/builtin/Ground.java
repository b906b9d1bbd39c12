package sunbeam.precompute.patch.builtin;

import java.util.stream.IntStream;

/**
 * What lies under the fingers of a {@link FingerSkin}: waviness with a density that falls as a power of the frequency,
 * and fine grain.
 *
 * @param waviness root mean square in metres
 * @param exponent of the density's fall
 * @param modes most periods of the waviness along the patch's side
 * @param grain root mean square in metres
 * @param grainLength correlation length of the grain in metres (standard deviation of the Gaussian that smooths it)
 */
public record Ground(double waviness, double exponent, int modes, double grain, double grainLength) {

    /** {@code samples * samples} heights in metres over a patch of the given side, periodic. */
    double[] heights(int samples, double side, SeededNoise noise) {
        double[] heights = PeriodicField.powerLaw(samples, samples, waviness, exponent, modes, modes, noise);
        double[] grains = new double[samples * samples];
        for (int i = 0; i < grains.length; i++) {
            grains[i] = noise.normal();
        }
        double[] kernel = kernel(grainLength * samples / side);
        grains = smoothed(smoothed(grains, kernel, samples, 1, samples), kernel, samples, samples, 1);
        for (int i = 0; i < heights.length; i++) {
            heights[i] += grain * grains[i];
        }
        return heights;
    }

    /** Half of a Gaussian, from its centre on, with squares that sum to 1, so that noise keeps its variance. */
    private static double[] kernel(double sigma) {
        double[] kernel = new double[1 + (int) Math.ceil(3 * sigma)];
        double squares = 0;
        for (int i = 0; i < kernel.length; i++) {
            kernel[i] = StrictMath.exp(-i * i / (2 * sigma * sigma));
            squares += (i == 0 ? 1 : 2) * kernel[i] * kernel[i];
        }
        for (int i = 0; i < kernel.length; i++) {
            kernel[i] /= StrictMath.sqrt(squares);
        }
        return kernel;
    }

    /** Convolution along one axis, round the period. */
    private static double[] smoothed(double[] values, double[] kernel, int size, int step, int lineStep) {
        int reach = kernel.length - 1;
        double[] result = new double[values.length];
        IntStream.range(0, size).parallel().forEach(line -> {
            double[] wrapped = new double[size + 2 * reach];
            for (int i = 0; i < wrapped.length; i++) {
                wrapped[i] = values[line * lineStep + Math.floorMod(i - reach, size) * step];
            }
            for (int i = 0; i < size; i++) {
                int middle = i + reach;
                double sum = kernel[0] * wrapped[middle];
                for (int k = 1; k <= reach; k++) {
                    sum += kernel[k] * (wrapped[middle - k] + wrapped[middle + k]);
                }
                result[line * lineStep + i * step] = sum;
            }
        });
        return result;
    }
}
