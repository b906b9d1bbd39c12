package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.PowerSpectrum2d;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/**
 * Power spectrum of a patch's heights up to what light can see (2 / 380 nm) or the samples hold (1 / (2 pitch)),
 * whichever is less. The sum of the bins is the variance of the transformed heights, less what lies beyond.
 *
 * @param bandX bins along x, symmetric about 0
 * @param bandY bins along y (upwards), symmetric about 0
 * @param width of the patch, metres; frequency along x = bin / width
 * @param height of the patch, metres
 * @param beyond variance of the transformed heights that lies beyond the bands, square metres
 * @param power square metres, {@code [(jy - bandY.first) * bandX.count + jx - bandX.first]}
 */
public record HeightSpectrum(Band bandX, Band bandY, double width, double height, double beyond, double[] power) {

    // Of the heights' variance.
    private static final double MUCH = 0.1;
    private static final double SHORTEST_PERIOD = SamplingCheck.SHORTEST_WAVELENGTH / 2;

    /** What light can see, cycles per metre. */
    static final double HIGHEST_FREQUENCY = 1 / SHORTEST_PERIOD;

    /** How the patch's edges are treated. */
    public enum Edges {
        /** One period of a surface that repeats: heights less their mean, each bin one exact frequency. */
        PERIODIC,
        /**
         * A piece of a surface: heights less their plane, under a Hann window along both axes, scaled to the variance.
         */
        TAPERED
    }

    /** Transforms the heights of a map without missing samples. */
    public static HeightSpectrum of(HeightMap map, Edges edges) {
        return of(map, edges, band(map.columns(), map.pitchX()), band(map.rows(), map.pitchY()));
    }

    /** Tapered, of all that the samples hold. */
    static HeightSpectrum ofAllFrequencies(HeightMap map) {
        int reachX = (map.columns() - 1) / 2;
        int reachY = (map.rows() - 1) / 2;
        return of(map, Edges.TAPERED, Band.of(-reachX, reachX), Band.of(-reachY, reachY));
    }

    private static HeightSpectrum of(HeightMap map, Edges edges, Band bandX, Band bandY) {
        boolean tapered = edges == Edges.TAPERED;
        HeightMap level = map.levelled(tapered ? Levelling.PLANE : Levelling.MEAN);
        double[] taperX = taper(map.columns(), tapered);
        double[] taperY = taper(map.rows(), tapered);
        double[] power = new PowerSpectrum2d(map.columns(), map.rows(), bandX.last(), bandY.last())
                .power((row, samples) -> {
                    for (int column = 0; column < map.columns(); column++) {
                        samples[column] = level.at(column, row) * taperX[column] * taperY[row];
                    }
                });
        double beyond = Math.max(
                0, variance(level, taperX, taperY) - Arrays.stream(power).sum());
        return new HeightSpectrum(bandX, bandY, map.width(), map.height(), beyond, power);
    }

    private static double variance(HeightMap level, double[] taperX, double[] taperY) {
        double sum = 0;
        for (int row = 0; row < level.rows(); row++) {
            for (int column = 0; column < level.columns(); column++) {
                double height = level.at(column, row) * taperX[column] * taperY[row];
                sum += height * height;
            }
        }
        return sum / ((double) level.columns() * level.rows());
    }

    private static Band band(int samples, double pitch) {
        int nyquist = (samples - 1) / 2;
        int visible = (int) Math.ceil(samples * pitch / SHORTEST_PERIOD);
        int reach = Math.min(nyquist, visible);
        return Band.of(-reach, reach);
    }

    /** Hann window of root mean square 1, or none. */
    private static double[] taper(int samples, boolean tapered) {
        double[] taper = new double[samples];
        for (int i = 0; i < samples; i++) {
            double sine = Math.sin(Math.PI * (i + 0.5) / samples);
            taper[i] = tapered && samples > 1 ? sine * sine / Math.sqrt(0.375) : 1;
        }
        return taper;
    }

    /** Whether a map's samples hold more than light can see. */
    static boolean endsBeforeSamplesDo(HeightMap map) {
        return Math.min(map.pitchX(), map.pitchY()) < 0.5 * SHORTEST_PERIOD;
    }

    /** Of the heights' variance, what lies beyond the bands; 0..1. */
    double shareBeyond() {
        return beyond / (beyond + Arrays.stream(power).sum());
    }

    /** What is finer than light can see, where that is much of the heights; a sentence without a full stop. */
    public Optional<String> describeBeyond() {
        double share = shareBeyond();
        return !(share >= MUCH) || !isCutByLight()
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s %% of the heights' variance have periods below %s, which diffract no visible light and are not looked"
                                + " for",
                        Decimals.rounded(100 * share, 2),
                        Lengths.format(SHORTEST_PERIOD)));
    }

    /** Whether samples hold more than light can see. */
    private boolean isCutByLight() {
        return Math.max(bandX.last() / width, bandY.last() / height) >= 1 / SHORTEST_PERIOD;
    }

    /** Power of a bin; 0 outside the bands. */
    public double at(int jx, int jy) {
        int column = jx - bandX.first();
        int row = jy - bandY.first();
        return column < 0 || row < 0 || column >= bandX.count() || row >= bandY.count()
                ? 0
                : power[row * bandX.count() + column];
    }

    /** Power at a frequency in cycles per metre, linear between bins; 0 outside the bands. */
    public double interpolated(double frequencyX, double frequencyY) {
        double x = frequencyX * width;
        double y = frequencyY * height;
        int jx = (int) Math.floor(x);
        int jy = (int) Math.floor(y);
        double lower = at(jx, jy) * (1 - (x - jx)) + at(jx + 1, jy) * (x - jx);
        double upper = at(jx, jy + 1) * (1 - (x - jx)) + at(jx + 1, jy + 1) * (x - jx);
        return lower * (1 - (y - jy)) + upper * (y - jy);
    }

    /** Whether a frequency lies within the bands. */
    public boolean covers(double frequencyX, double frequencyY) {
        return Math.abs(frequencyX * width) <= bandX.last() + 1e-9
                && Math.abs(frequencyY * height) <= bandY.last() + 1e-9;
    }

    /** Averaged with a Gaussian over bins: less noise, peaks a few bins wide. An axis without bins stays as it is. */
    public HeightSpectrum smoothed(double sigmaBins) {
        double[] both = convolvedColumns(convolvedRows(gaussian(sigmaBins)), gaussian(sigmaBins));
        return new HeightSpectrum(bandX, bandY, width, height, beyond, both);
    }

    private static double[] gaussian(double sigma) {
        int radius = (int) Math.ceil(4 * sigma);
        double[] kernel = new double[2 * radius + 1];
        for (int i = -radius; i <= radius; i++) {
            kernel[i + radius] = Math.exp(-0.5 * i * i / (sigma * sigma));
        }
        return kernel;
    }

    /** Beyond the ends of a line there is nothing. */
    private static double norm(double[] kernel, int length) {
        return length == 1 ? kernel[kernel.length / 2] : Arrays.stream(kernel).sum();
    }

    private double[] convolvedRows(double[] kernel) {
        int radius = kernel.length / 2;
        int length = bandX.count();
        double norm = norm(kernel, length);
        double[] result = new double[power.length];
        IntStream.range(0, bandY.count()).parallel().forEach(row -> {
            int start = row * length;
            for (int i = 0; i < length; i++) {
                double value = 0;
                int last = Math.min(length - 1, i + radius);
                for (int j = Math.max(0, i - radius); j <= last; j++) {
                    value += kernel[j - i + radius] * power[start + j];
                }
                result[start + i] = value / norm;
            }
        });
        return result;
    }

    /** Row by row, as they lie in memory. */
    private double[] convolvedColumns(double[] values, double[] kernel) {
        int radius = kernel.length / 2;
        int width = bandX.count();
        double norm = norm(kernel, bandY.count());
        double[] result = new double[values.length];
        IntStream.range(0, bandY.count()).parallel().forEach(row -> {
            int last = Math.min(bandY.count() - 1, row + radius);
            for (int other = Math.max(0, row - radius); other <= last; other++) {
                double weight = kernel[other - row + radius] / norm;
                for (int i = 0; i < width; i++) {
                    result[row * width + i] += weight * values[other * width + i];
                }
            }
        });
        return result;
    }
}
