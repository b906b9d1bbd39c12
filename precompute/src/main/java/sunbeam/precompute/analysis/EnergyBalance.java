package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform2d;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.text.Text;

/**
 * Light that the scalar model sends into all orders of a surface, in proportion to what a mirror of its material sends out.
 * An order with the bin F_j takes (1 + wi.wr)^2 / (w^2 cos theta_i cos theta_r) |F_j(w)|^2, the integral of the BRDF over it
 * (docs/theory.md); Schlick's factor is left out.
 *
 * @param ratio of the light sent out, 1 for a mirror
 * @param wavelength of the light, meters
 */
public record EnergyBalance(double ratio, double wavelength) {
    /** Ratio from which a surface is reported. */
    public static final double LARGEST = 1.05;

    // Samples along a side: a wider scan stands for itself by its middle.
    private static final int MOST_SAMPLES = 256;
    // Orders of nearly the same w share a transform. Up to so many differ in w are exact.
    private static final int TRANSFORMS = 8;
    private static final double STEP = 20e-9;

    /** A visible order: its bins, w, and its factor of |F_j|^2. */
    private record Order(int x, int y, double w, double factor) {}

    /**
     * The wavelength at which a surface sends out most.
     *
     * @param wi direction to the light, in the patch's frame
     */
    public static EnergyBalance largest(HeightMap map, Direction wi) {
        HeightMap middle = middle(map);
        int steps = (int) Math.round((CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) / STEP);
        return IntStream.rangeClosed(0, steps)
                .mapToObj(i -> at(middle, wi, CieTable.MINIMUM_WAVELENGTH + i * STEP))
                .max(Comparator.comparingDouble(EnergyBalance::ratio))
                .orElseThrow();
    }

    /** The balance at one wavelength, of at most {@value #MOST_SAMPLES} samples along a side. */
    public static EnergyBalance at(HeightMap map, Direction wi, double wavelength) {
        HeightMap middle = middle(map);
        List<Order> orders = orders(middle, wi, wavelength);
        orders.sort(Comparator.comparingDouble(Order::w));
        int transforms = Math.min(TRANSFORMS, orders.size());
        double sum = 0;
        for (int i = 0; i < transforms; i++) {
            sum += sum(
                    middle,
                    wavelength,
                    orders.subList(i * orders.size() / transforms, (i + 1) * orders.size() / transforms));
        }
        return new EnergyBalance(sum, wavelength);
    }

    private static HeightMap middle(HeightMap map) {
        int columns = Math.min(MOST_SAMPLES, map.columns());
        int rows = Math.min(MOST_SAMPLES, map.rows());
        int left = (map.columns() - columns) / 2;
        int top = (map.rows() - rows) / 2;
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = map.at(left + i % columns, top + i / columns);
        }
        return HeightMap.owning(columns, rows, map.pitchX(), map.pitchY(), heights);
    }

    private static List<Order> orders(HeightMap map, Direction wi, double wavelength) {
        List<Order> orders = new ArrayList<>();
        int mostX = most(map.columns(), map.width(), wavelength);
        int mostY = most(map.rows(), map.height(), wavelength);
        for (int y = -mostY; y <= mostY; y++) {
            for (int x = -mostX; x <= mostX; x++) {
                double outX = -wi.x() - wavelength * x / map.width();
                double outY = -wi.y() - wavelength * y / map.height();
                double square = 1 - outX * outX - outY * outY;
                if (square > 0) {
                    DirectionPair pair = new DirectionPair(wi, new Direction(outX, outY, Math.sqrt(square)));
                    double ratio = (1 + pair.wi().dot(pair.wr())) / pair.w();
                    double factor = ratio * ratio / (pair.cosThetaI() * pair.cosThetaR());
                    orders.add(new Order(x, y, pair.w(), factor));
                }
            }
        }
        return orders;
    }

    /** Bins on each side of 0 that can be visible and are no replicas of others. */
    private static int most(int samples, double length, double wavelength) {
        return Math.min((samples - 1) / 2, (int) Math.ceil(2 * length / wavelength));
    }

    /** Light in some orders, by their mean w. */
    private static double sum(HeightMap map, double wavelength, List<Order> orders) {
        double w = orders.stream().mapToDouble(Order::w).average().orElseThrow();
        Band bandX = band(orders.stream().mapToInt(Order::x).toArray());
        Band bandY = band(orders.stream().mapToInt(Order::y).toArray());
        double perMeter = 2 * Math.PI / wavelength * w;
        ComplexVector bins = new BandTransform2d(map.columns(), map.rows(), bandX, bandY)
                .transform((row, real, imaginary) -> {
                    for (int column = 0; column < map.columns(); column++) {
                        double phase = perMeter * map.at(column, row);
                        real[column] = Math.cos(phase);
                        imaginary[column] = Math.sin(phase);
                    }
                });
        double sum = 0;
        for (Order order : orders) {
            int at = (order.y() - bandY.first()) * bandX.count() + order.x() - bandX.first();
            sum += order.factor() * (Math.pow(bins.real()[at], 2) + Math.pow(bins.imaginary()[at], 2));
        }
        return sum;
    }

    private static Band band(int... bins) {
        return Band.of(
                IntStream.of(bins).min().orElseThrow(), IntStream.of(bins).max().orElseThrow());
    }

    /** A warning where the surface sends out more than {@link #LARGEST}. */
    public Optional<String> warning() {
        return ratio <= LARGEST
                ? Optional.empty()
                : Optional.of(Text.format(
                        "at %.0f nm the model sends out %.2f times the light of a mirror, as orders lie flat: scalar theory"
                                + " does not keep energy there (docs/theory.md)",
                        wavelength * 1e9, ratio));
    }
}
