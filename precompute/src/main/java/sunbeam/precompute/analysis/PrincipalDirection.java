package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.Locale;
import java.util.OptionalDouble;
import org.apache.commons.math3.distribution.TDistribution;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Crop;

/**
 * The direction in which a surface spreads most of its colors: across the lines of a grating.
 *
 * @param azimuthDegrees counter-clockwise from +x, above -90 to 90; 0 where no direction stands out
 * @param halfWidthDegrees 0 where it is exact; else of the interval that holds the direction of a larger scan of the same surface with a probability of
 *     95 %, from how parts of this one differ, 90 at most; empty where it is too small to be parted
 * @param strength 0..1: 0 where all directions are alike, 1 where there is only one
 */
public record PrincipalDirection(double azimuthDegrees, OptionalDouble halfWidthDegrees, double strength) {
    // Coarser waves send light beside the mirror direction, where it has no color.
    private static final double COARSEST_PERIOD = 5e-6;
    // Finer ones send light along the normal nowhere.
    private static final double FINEST_PERIOD = 380e-9;
    // A smaller patch is taken for one period; of a larger one, the border must not count.
    private static final double SMALLEST_PIECE = 10e-6;
    // Parts along each side, and samples and metres along a part's side.
    private static final int MOST_PARTS = 3;
    private static final int FEWEST_PARTS = 2;
    private static final int FEWEST_SAMPLES = 16;
    private static final double SMALLEST_PART = 3e-6;
    private static final double ANY = 90;
    // Degrees: by as much overtones of walls between samples, which come back from beyond half the sampling frequency,
    // turned
    // the axis of simulated gratings.
    private static final double OVERTONES = 2;

    /** Of a surface whose parts nobody asks about: the azimuth alone. */
    public static double azimuthDegrees(HeightMap map) {
        return azimuthDegrees(sums(map));
    }

    /**
     * The principal axis of the heights' power spectrum between periods of 380 nm and 5 um, each wave weighted by its power
     * times its frequency; of all waves where those have no power.
     */
    public static PrincipalDirection of(HeightMap map) {
        double[] sums = sums(map);
        return new PrincipalDirection(azimuthDegrees(sums), halfWidth(map, sums), strength(sums));
    }

    private static double azimuthDegrees(double[] sums) {
        // Rounding alone prefers no direction.
        if (Math.hypot(sums[0], sums[1]) <= 1e-9 * sums[2]) {
            return 0;
        }
        double angle = Math.toDegrees(0.5 * Math.atan2(sums[1], sums[0]));
        return angle <= -90 ? angle + 180 : angle + 0.0;
    }

    /** How parts beside each other stray from the whole: Student's interval of their mean, and the mean's distance from the whole. */
    private static OptionalDouble halfWidth(HeightMap map, double[] whole) {
        for (int parts = MOST_PARTS; parts >= FEWEST_PARTS; parts--) {
            boolean enough = Math.min(map.columns(), map.rows()) >= parts * FEWEST_SAMPLES
                    && Math.min(map.width(), map.height()) >= parts * SMALLEST_PART;
            if (enough) {
                return OptionalDouble.of(halfWidth(map, whole, parts));
            }
        }
        return OptionalDouble.empty();
    }

    private static double halfWidth(HeightMap map, double[] whole, int parts) {
        double length = Math.hypot(whole[0], whole[1]);
        int count = parts * parts;
        double[] across = new double[count];
        double along = 0;
        for (int i = 0; i < count; i++) {
            double left = map.width() * (i % parts) / parts;
            int row = i / parts;
            double bottom = map.height() * row / parts;
            Crop part = new Crop(left, left + map.width() / parts, bottom, bottom + map.height() / parts);
            double[] of = sums(part.apply(map), HeightSpectrum.Edges.TAPERED);
            // Twice the angle to the whole's axis, as a vector.
            across[i] = (of[1] * whole[0] - of[0] * whole[1]) / length;
            along += (of[0] * whole[0] + of[1] * whole[1]) / length / count;
        }
        double mean = Arrays.stream(across).average().orElseThrow();
        double squares = Arrays.stream(across)
                .map(value -> (value - mean) * (value - mean))
                .sum();
        double error = new TDistribution(count - 1).inverseCumulativeProbability(0.5 + 0.5 * GratingPeriod.PROBABILITY)
                * Math.sqrt(squares / count / (count - 1));
        double degrees = Math.toDegrees(0.5 * (error + Math.abs(mean)) / along);
        return along > 0 ? Math.min(ANY, Math.hypot(degrees, OVERTONES)) : ANY;
    }

    /** Of a surface that repeats without end: nothing of it is left out. */
    public static PrincipalDirection ofPeriod(HeightMap map) {
        double[] sums = sums(map);
        return new PrincipalDirection(azimuthDegrees(sums), OptionalDouble.of(0), strength(sums));
    }

    private static double strength(double[] sums) {
        return sums[2] > 0 ? Math.hypot(sums[0], sums[1]) / sums[2] : 0;
    }

    /**
     * In words: "11 +- 2 degrees (95 %)"; whole degrees alone where nobody can say how well it is known, and a tenth of one
     * where it is exact.
     */
    public String describe() {
        if (halfWidthDegrees.isPresent() && halfWidthDegrees.getAsDouble() == 0) {
            return String.format(Locale.ROOT, "%.1f degrees", azimuthDegrees + 0.0);
        }
        long whole = Math.round(azimuthDegrees);
        return halfWidthDegrees.isPresent()
                ? String.format(
                        Locale.ROOT,
                        "%d +- %.0f degrees (95 %%)",
                        whole,
                        Math.ceil(halfWidthDegrees.getAsDouble() - 0.05))
                : whole + " degrees";
    }

    private static double[] sums(HeightMap map) {
        boolean piece = Math.min(map.width(), map.height()) >= SMALLEST_PIECE;
        return sums(map, piece ? HeightSpectrum.Edges.TAPERED : HeightSpectrum.Edges.PERIODIC);
    }

    private static double[] sums(HeightMap map, HeightSpectrum.Edges edges) {
        HeightSpectrum spectrum = HeightSpectrum.of(map, edges);
        double[] sums = sums(spectrum, 1 / COARSEST_PERIOD, 1 / FINEST_PERIOD);
        return sums[2] == 0 ? sums(spectrum, 0, Double.MAX_VALUE) : sums;
    }

    /** Weights times cos and sin of twice the azimuth, and weights. */
    private static double[] sums(HeightSpectrum spectrum, double lowest, double highest) {
        double[] sums = new double[3];
        int columns = spectrum.bandX().count();
        for (int i = 0; i < spectrum.power().length; i++) {
            double fx = (spectrum.bandX().first() + i % columns) / spectrum.width();
            double fy = (spectrum.bandY().first() + i / columns) / spectrum.height();
            double frequency = Math.hypot(fx, fy);
            if (frequency > 0 && frequency >= lowest && frequency <= highest) {
                double weight = spectrum.power()[i] * frequency;
                sums[0] += weight * (fx * fx - fy * fy) / (frequency * frequency);
                sums[1] += weight * 2 * fx * fy / (frequency * frequency);
                sums[2] += weight;
            }
        }
        return sums;
    }
}
