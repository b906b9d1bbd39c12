package sunbeam.app.gpu;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;

/** Directions for tests, the same at every run. */
final class Directions {
    private final SplittableRandom random;

    Directions(long seed) {
        random = new SplittableRandom(seed);
    }

    /** Both directions anywhere in the hemisphere, evenly in the disc. */
    List<DirectionPair> anywhere(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> new DirectionPair(direction(1), direction(1)))
                .toList();
    }

    /** Both directions anywhere in the hemisphere and any visible wavelength. */
    List<Query> queries(int count) {
        return anywhere(count).stream()
                .map(pair -> new Query(pair, 380e-9 + 400e-9 * random.nextDouble()))
                .toList();
    }

    /** Light of one direction, views evenly in the disc. */
    List<DirectionPair> views(Direction light, int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> new DirectionPair(light, direction(1)))
                .toList();
    }

    /**
     * Directions and wavelengths that see one of the patch's orders, at most two deviations of the window's spectrum off
     * its middle: elsewhere a window larger than the patch leaves nothing to see.
     */
    List<Query> nearOrders(HeightMap map, CoherenceWindow window, int count) {
        List<Query> queries = new ArrayList<>();
        while (queries.size() < count) {
            Direction light = direction(0.95);
            Direction view = direction(0.95);
            double wavelength = 380e-9 + 400e-9 * random.nextDouble();
            double fx =
                    order(-(light.x() + view.x()) / wavelength, map.width()) + 2 * signed() * window.sigmaFrequency();
            double fy =
                    order(-(light.y() + view.y()) / wavelength, map.height()) + 2 * signed() * window.sigmaFrequency();
            double x = -fx * wavelength - light.x();
            double y = -fy * wavelength - light.y();
            if (x * x + y * y < 0.95) {
                queries.add(new Query(new DirectionPair(light, Direction.ofDisc(x, y)), wavelength));
            }
        }
        return queries;
    }

    /**
     * Light in the xz plane, and the view that sees a frequency.
     *
     * @param thetaDegrees angle of the light to the normal, towards +x
     * @param fx u / lambda, cycles per meter
     * @param fy v / lambda, cycles per meter
     */
    static Query seeing(double thetaDegrees, double fx, double fy, double wavelength) {
        Direction light = Direction.ofDegrees(thetaDegrees, 0);
        Direction view = Direction.ofDisc(-fx * wavelength - light.x(), -fy * wavelength - light.y());
        return new Query(new DirectionPair(light, view), wavelength);
    }

    private static double order(double frequency, double period) {
        return Math.rint(frequency * period) / period;
    }

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private Direction direction(double radius) {
        double r = radius * Math.sqrt(random.nextDouble());
        double phi = 2 * Math.PI * random.nextDouble();
        return Direction.ofDisc(r * Math.cos(phi), r * Math.sin(phi));
    }
}
