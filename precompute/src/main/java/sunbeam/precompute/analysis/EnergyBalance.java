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
 * Light that the scalar model sends into all orders of a surface, relative to the light that a mirror of the same material reflects. The
 * order of DFT bin F_j has the share (1 + wi.wr)^2 / (w^2 cos theta_i cos theta_r) |F_j(w)|^2. This is the integral of the BRDF over the
 * order without Schlick's factor (docs/theory.md).
 *
 * @param ratio light of all orders over that of a mirror; 1 if the model conserves energy
 * @param wavelength meters
 */
public record EnergyBalance(double ratio, double wavelength) {
    /** Ratio above which {@link #warning} reports a surface. */
    public static final double LARGEST = 1.05;

    // Samples along a side; a larger scan is evaluated in its middle.
    private static final int MOST_SAMPLES = 256;
    // With more orders than this, orders of similar w share a transform at their mean w.
    private static final int MOST_TRANSFORMS = 8;
    // Meters.
    private static final double WAVELENGTH_STEP = 20e-9;

    /** Visible order: its bins along x and y, its w, and the factor of |F_j|^2 in its share of the light. */
    private record Order(int x, int y, double w, double factor) {}

    /**
     * Returns the balance at the visible wavelength, in steps of 20 nm, where the ratio is largest.
     *
     * @param wi direction to the light, in the patch's frame
     */
    public static EnergyBalance largest(HeightMap map, Direction wi) {
        HeightMap middle = middle(map);
        int steps = (int) Math.round((CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) / WAVELENGTH_STEP);
        return IntStream.rangeClosed(0, steps)
                .mapToObj(i -> at(middle, wi, CieTable.MINIMUM_WAVELENGTH + i * WAVELENGTH_STEP))
                .max(Comparator.comparingDouble(EnergyBalance::ratio))
                .orElseThrow();
    }

    /** Returns the balance at a wavelength in meters, of the middle {@value #MOST_SAMPLES} samples along each side of a larger scan. */
    public static EnergyBalance at(HeightMap map, Direction wi, double wavelength) {
        HeightMap middle = middle(map);
        List<Order> orders = orders(middle, wi, wavelength);
        orders.sort(Comparator.comparingDouble(Order::w));
        int transforms = Math.min(MOST_TRANSFORMS, orders.size());
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
        int mostX = highestBin(map.columns(), map.width(), wavelength);
        int mostY = highestBin(map.rows(), map.height(), wavelength);
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

    /** Returns the highest bin along an axis that can be visible and is no alias of another. */
    private static int highestBin(int samples, double length, double wavelength) {
        return Math.min((samples - 1) / 2, (int) Math.ceil(2 * length / wavelength));
    }

    /** Evaluated at the mean w of the orders. */
    private static double sum(HeightMap map, double wavelength, List<Order> orders) {
        double w = orders.stream().mapToDouble(Order::w).average().orElseThrow();
        Band bandX = band(orders.stream().mapToInt(Order::x).toArray());
        Band bandY = band(orders.stream().mapToInt(Order::y).toArray());
        double phasePerMeter = 2 * Math.PI / wavelength * w;
        ComplexVector bins = new BandTransform2d(map.columns(), map.rows(), bandX, bandY)
                .transform((row, real, imaginary) -> {
                    for (int column = 0; column < map.columns(); column++) {
                        double phase = phasePerMeter * map.at(column, row);
                        real[column] = Math.cos(phase);
                        imaginary[column] = Math.sin(phase);
                    }
                });
        double sum = 0;
        for (Order order : orders) {
            int index = (order.y() - bandY.first()) * bandX.count() + order.x() - bandX.first();
            sum += order.factor() * (Math.pow(bins.real()[index], 2) + Math.pow(bins.imaginary()[index], 2));
        }
        return sum;
    }

    private static Band band(int... bins) {
        return Band.of(
                IntStream.of(bins).min().orElseThrow(), IntStream.of(bins).max().orElseThrow());
    }

    /** Returns a warning if the ratio exceeds {@link #LARGEST}, else empty. */
    public Optional<String> warning() {
        return ratio <= LARGEST
                ? Optional.empty()
                : Optional.of(Text.format(
                        "at %.0f nm the model sends out %.2f times the light of a mirror, as orders lie flat: scalar theory"
                                + " does not keep energy there (docs/theory.md)",
                        wavelength * 1e9, ratio));
    }
}
