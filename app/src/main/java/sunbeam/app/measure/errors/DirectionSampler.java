package sunbeam.app.measure.errors;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;

/** Random pairs of directions with a wavelength, the same for the same seed. */
public final class DirectionSampler {
    // Closer to the horizon no radiance is left to divide by.
    private static final double LOWEST_COSINE = 0.01;
    private static final int MOST_TRIES = 10_000;

    private final double width;
    private final double height;
    private final double sigmaFrequency;
    private final SplittableRandom random;
    private final Supplier<Direction> lights;

    /** A sampler for a patch under a window; lights are uniform on the hemisphere. */
    public DirectionSampler(HeightMap map, CoherenceWindow window, long seed) {
        this(map, window, seed, Optional.empty());
    }

    /** The same, of one light where it is given. */
    public DirectionSampler(HeightMap map, CoherenceWindow window, long seed, Optional<Direction> light) {
        this.width = map.width();
        this.height = map.height();
        this.sigmaFrequency = window.sigmaFrequency();
        this.random = new SplittableRandom(seed);
        this.lights = () -> light.orElseGet(this::hemisphere);
    }

    /** A view uniform on the hemisphere, the wavelength uniform in 380..780 nm. */
    public Query uniform() {
        return new Query(new DirectionPair(lights.get(), hemisphere()), wavelength());
    }

    /**
     * Aimed at a diffraction order of the patch, and within the width that the window gives it: along x, along y (as
     * gratings have them) or anywhere, in equal parts; uniform where no order can be seen.
     */
    public Query aimed() {
        int kind = random.nextInt(3);
        for (int i = 0; i < MOST_TRIES; i++) {
            Direction light = lights.get();
            double wavelength = wavelength();
            double fx = kind == 1 ? 0 : order(width, wavelength);
            double fy = kind == 0 ? 0 : order(height, wavelength);
            double x = -light.x() - wavelength * (fx + sigmaFrequency * random.nextGaussian());
            double y = -light.y() - wavelength * (fy + sigmaFrequency * random.nextGaussian());
            Direction view = Direction.ofDisc(x, y);
            if (view.z() > LOWEST_COSINE) {
                return new Query(new DirectionPair(light, view), wavelength);
            }
        }
        // A grazing light of which a narrow patch sends no order upwards.
        return uniform();
    }

    /** Frequency of one of the orders that a pair of directions can see, cycles per metre. */
    private double order(double period, double wavelength) {
        int last = (int) Math.floor(2 * period / wavelength);
        return random.nextInt(-last, last + 1) / period;
    }

    private double wavelength() {
        return random.nextDouble(CieTable.MINIMUM_WAVELENGTH, CieTable.MAXIMUM_WAVELENGTH);
    }

    /** Equal areas of the sphere have equal heights. */
    private Direction hemisphere() {
        double z = random.nextDouble(LOWEST_COSINE, 1);
        double phi = random.nextDouble(2 * Math.PI);
        double sine = Math.sqrt(1 - z * z);
        return new Direction(sine * Math.cos(phi), sine * Math.sin(phi), z);
    }
}
