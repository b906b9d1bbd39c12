package sunbeam.precompute.reference;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

public final class DirectionPairs {
    private DirectionPairs() {}

    /** Only the sum of both directions counts: one has it, the other is 0. */
    public static DirectionPair of(double u, double v, double w) {
        return new DirectionPair(new Direction(-u, -v, -w), new Direction(0, 0, 0));
    }

    /**
     * Light in the xz plane and the view at a frequency.
     *
     * @param thetaDegrees angle of the light to the normal, towards +x
     * @param fx u / lambda, cycles per meter
     * @param fy v / lambda, cycles per meter
     */
    static DirectionPair seeing(double thetaDegrees, double fx, double fy, double wavelength) {
        Direction light = Direction.ofDegrees(thetaDegrees, 0);
        return new DirectionPair(light, Direction.ofDisc(-fx * wavelength - light.x(), -fy * wavelength - light.y()));
    }

    public static DirectionPair random(SplittableRandom random) {
        return new DirectionPair(direction(random), direction(random));
    }

    /** Uniform on the hemisphere. */
    public static Direction direction(SplittableRandom random) {
        return Direction.ofDegrees(Math.toDegrees(Math.acos(random.nextDouble())), 360 * random.nextDouble());
    }

    public static List<DirectionPair> random(int count) {
        SplittableRandom random = new SplittableRandom(2);
        return Stream.generate(() -> random(random)).limit(count).toList();
    }
}
