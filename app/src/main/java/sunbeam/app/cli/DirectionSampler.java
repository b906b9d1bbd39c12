package sunbeam.app.cli;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;

/** Sampler of random pairs of directions with a wavelength; equal seeds yield equal pairs. */
public final class DirectionSampler {
    // Least cosine of a direction to the normal: relative errors divide by the radiance, which vanishes at the horizon.
    private static final double LOWEST_COSINE = 0.01;
    private static final int MOST_TRIES = 10_000;

    private final double width;
    private final double height;
    private final double sigmaFrequency;
    private final SplittableRandom random;
    private final Supplier<Direction> lights;

    public DirectionSampler(HeightMap map, CoherenceWindow window, long seed) {
        this(map, window, seed, Optional.empty());
    }

    /** @param light direction of all lights; if empty, uniform on the hemisphere */
    public DirectionSampler(HeightMap map, CoherenceWindow window, long seed, Optional<Direction> light) {
        this.width = map.width();
        this.height = map.height();
        this.sigmaFrequency = window.sigmaFrequency();
        this.random = new SplittableRandom(seed);
        this.lights = () -> light.orElseGet(this::hemisphere);
    }

    /** View uniform on the hemisphere, wavelength uniform in 380..780 nm. */
    public DirectionQuery uniform() {
        return new DirectionQuery(new DirectionPair(lights.get(), hemisphere()), wavelength());
    }

    /** View near an order, normally distributed by its width: a third along x, along y, and anywhere; uniform if none is visible. */
    public DirectionQuery aimed() {
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
                return new DirectionQuery(new DirectionPair(light, view), wavelength);
            }
        }
        // A narrow patch under grazing light diffracts no order above the horizon.
        return uniform();
    }

    /** Frequency of a random order that some directions select, in cycles per meter. */
    private double order(double period, double wavelength) {
        int last = (int) Math.floor(2 * period / wavelength);
        return random.nextInt(-last, last + 1) / period;
    }

    private double wavelength() {
        return random.nextDouble(CieTable.MINIMUM_WAVELENGTH, CieTable.MAXIMUM_WAVELENGTH);
    }

    /** Zones of equal height have equal areas on a sphere, so z is uniform. */
    private Direction hemisphere() {
        double z = random.nextDouble(LOWEST_COSINE, 1);
        double phi = random.nextDouble(2 * Math.PI);
        double sine = Math.sqrt(1 - z * z);
        return new Direction(sine * Math.cos(phi), sine * Math.sin(phi), z);
    }
}
