package sunbeam.app.promise;

import java.util.SplittableRandom;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;

enum RandomAim {
    SPECULAR,
    ORDER,
    SKIRT,
    VALLEY,
    GRAZING,
    ANYWHERE;

    private static final int MOST_TRIES = 1000;
    private static final double LOWEST_COSINE = 0.01;
    private static final double GRAZING_COSINE = 0.05;

    /**
     * A pair of directions.
     *
     * @param wavelength meters, at which orders are aimed at
     * @param sigmaFrequency of the window, cycles per meter
     */
    DirectionPair draw(SplittableRandom random, HeightMap map, double wavelength, double sigmaFrequency) {
        for (int tries = 0; tries < MOST_TRIES; tries++) {
            Direction light = hemisphere(random, this == GRAZING ? GRAZING_COSINE : 1);
            Direction view = this == GRAZING || this == ANYWHERE
                    ? hemisphere(random, 1)
                    : aimed(random, light, map, wavelength, sigmaFrequency);
            if (view.z() > LOWEST_COSINE) {
                return new DirectionPair(light, view);
            }
        }
        // The valleys of a patch smaller than a wavelength lie beyond the horizon.
        return ANYWHERE.draw(random, map, wavelength, sigmaFrequency);
    }

    private Direction aimed(
            SplittableRandom random, Direction light, HeightMap map, double wavelength, double sigmaFrequency) {
        double fx = 0;
        double fy = 0;
        if (this != SPECULAR) {
            int axis = random.nextInt(3);
            double half = this == VALLEY ? 0.5 : 0;
            fx = axis == 1 ? 0 : (order(random, map.width(), wavelength) + half) / map.width();
            fy = axis == 0 ? 0 : (order(random, map.height(), wavelength) + half) / map.height();
        }
        double distance = sigmaFrequency
                * switch (this) {
                    case SPECULAR -> 4 * random.nextDouble();
                    case SKIRT -> random.nextDouble(1, 4.5);
                    default -> random.nextDouble();
                };
        double angle = random.nextDouble(2 * Math.PI);
        double x = -light.x() - wavelength * (fx + distance * Math.cos(angle));
        double y = -light.y() - wavelength * (fy + distance * Math.sin(angle));
        return Direction.ofDisc(x, y);
    }

    private static int order(SplittableRandom random, double period, double wavelength) {
        int last = (int) Math.floor(2 * period / wavelength);
        return random.nextInt(-last, last + 1);
    }

    /** Equal areas of the sphere have equal heights. */
    private static Direction hemisphere(SplittableRandom random, double highest) {
        double z = random.nextDouble(LOWEST_COSINE, highest);
        double phi = random.nextDouble(2 * Math.PI);
        double sine = Math.sqrt(1 - z * z);
        return new Direction(sine * Math.cos(phi), sine * Math.sin(phi), z);
    }

    static double wavelength(SplittableRandom random) {
        return random.nextDouble(CieTable.MINIMUM_WAVELENGTH, CieTable.MAXIMUM_WAVELENGTH);
    }
}
