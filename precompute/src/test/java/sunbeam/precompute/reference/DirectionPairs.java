package sunbeam.precompute.reference;

import java.util.SplittableRandom;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

final class DirectionPairs {
    private DirectionPairs() {}

    /**
     * Light in the xz plane and the view at a frequency.
     *
     * @param thetaDegrees angle of the light to the normal, towards +x
     * @param fx u / lambda, cycles per meter
     * @param fy v / lambda, cycles per meter
     * @throws IllegalArgumentException when no view sees it
     */
    static DirectionPair seeing(double thetaDegrees, double fx, double fy, double wavelength) {
        Direction light = Direction.ofDegrees(thetaDegrees, 0);
        double x = -fx * wavelength - light.x();
        double y = -fy * wavelength - light.y();
        if (x * x + y * y > 1) {
            throw new IllegalArgumentException("evanescent: " + x + ", " + y);
        }
        return new DirectionPair(light, Direction.ofDisc(x, y));
    }

    static DirectionPair random(SplittableRandom random) {
        return new DirectionPair(direction(random), direction(random));
    }

    private static Direction direction(SplittableRandom random) {
        return Direction.ofDegrees(85 * random.nextDouble(), 360 * random.nextDouble());
    }

    /** The same pair of directions seen from below: (u, v, w) changes its sign. */
    static DirectionPair opposite(DirectionPair pair) {
        return new DirectionPair(opposite(pair.wi()), opposite(pair.wr()));
    }

    private static Direction opposite(Direction direction) {
        return new Direction(-direction.x(), -direction.y(), -direction.z());
    }
}
