package sunbeam.precompute.analysis;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Diffracted light over that of a mirror of the material (1 conserves energy) at a wavelength in meters.
 *
 * @param pitch largest distance of samples, meters
 */
public record EnergyBalance(double ratio, double wavelength, double pitch) {
    public static final double LARGEST = 1.05;
    // Orders of a part of 256 x 256 samples, 65 nm apart, that are summed in a millisecond.
    private static final long MOST_ORDERS = 40_000;
    private static final int MOST_SAMPLES = 256;
    // Coarser samples have more orders each: as many as 256 samples, 190 nm apart, have in a second.
    private static final double LONGEST_PART = 48e-6;
    private static final int FEWEST_SAMPLES = 64;
    // Orders that take some seconds.
    private static final long TOO_MANY_ORDERS = 4_000_000;
    // Meters; deeper reliefs take more than a second.
    private static final double DEEPEST = 6e-6;
    private static final double WAVELENGTH_STEP = 20e-9;

    /**
     * Returns the balance of the largest ratio at wavelengths 20 nm apart, for light in the patch's frame; empty for a relief beyond 6 um
     * or a pitch beyond 3 um, which take too long.
     */
    public static Optional<EnergyBalance> largest(HeightMap map, RefractiveIndex index, Direction wi) {
        HeightMap middle = middle(map);
        if (middle.relief() > DEEPEST || hasTooManyOrders(map)) {
            return Optional.empty();
        }
        double pitch = Math.max(map.pitchX(), map.pitchY());
        OrderSpectrum spectrum = new OrderSpectrum(middle);
        int steps = (int) Math.round((CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) / WAVELENGTH_STEP);
        return IntStream.rangeClosed(0, steps)
                .parallel()
                .mapToDouble(i -> CieTable.MINIMUM_WAVELENGTH + i * WAVELENGTH_STEP)
                .mapToObj(wavelength -> new EnergyBalance(spectrum.sum(index, wi, wavelength, 0), wavelength, pitch))
                .max(Comparator.comparingDouble(EnergyBalance::ratio));
    }

    /** Returns the whole map if it has few orders, else its middle, whose borders are blended. */
    static HeightMap middle(HeightMap map) {
        if (OrderSpectrum.orders(map) <= MOST_ORDERS) {
            return map;
        }
        int columns = samples(map.columns(), map.pitchX());
        int rows = samples(map.rows(), map.pitchY());
        return Edges.BLEND.apply(map.part((map.columns() - columns) / 2, (map.rows() - rows) / 2, columns, rows));
    }

    private static int samples(int all, double pitch) {
        int most = (int) Math.max(FEWEST_SAMPLES, Math.min(MOST_SAMPLES, LONGEST_PART / pitch));
        return Math.min(most, all);
    }

    /** Whether samples are so far apart that the orders by which they repeat the spectrum take too long. */
    public static boolean hasTooManyOrders(HeightMap map) {
        return OrderSpectrum.orders(middle(map)) > TOO_MANY_ORDERS;
    }

    public Optional<String> warning() {
        // Light from any direction has no repeated order above the horizon with two samples in a wavelength.
        String cause = pitch > 0.5 * wavelength
                ? "samples " + Lengths.rounded(pitch, 3) + " apart, which repeat the spectrum, and of "
                : "";
        String words = "at %.0f nm the model reflects %.2f times the light of a mirror, because of %sorders near the"
                + " horizon, where scalar theory does not conserve energy (docs/theory.md)";
        return Optional.of(Text.format(words, wavelength * 1e9, ratio, cause)).filter(large -> ratio > LARGEST);
    }
}
