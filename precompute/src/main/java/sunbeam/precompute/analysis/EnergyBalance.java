package sunbeam.precompute.analysis;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.text.Text;

/**
 * Total diffracted light of a surface in the scalar model ({@link OrderSpectrum}), relative to a mirror of the same material.
 *
 * @param ratio light of all orders over that of a mirror; 1 if the model conserves energy
 * @param wavelength meters
 */
public record EnergyBalance(double ratio, double wavelength) {
    /** Ratio above which {@link #warning} reports a surface. */
    public static final double LARGEST = 1.05;

    // Samples along a side, beyond which only the middle is evaluated.
    private static final int MOST_SAMPLES = 256;
    // Meters; deeper reliefs take more than a second.
    private static final double DEEPEST = 6e-6;
    // Meters.
    private static final double WAVELENGTH_STEP = 20e-9;

    /**
     * Returns the balance at the visible wavelength, in steps of 20 nm, where the ratio is largest; empty for a relief of more than 6 um,
     * which takes too long.
     *
     * @param wi direction to the light, in the patch's frame
     */
    public static Optional<EnergyBalance> largest(HeightMap map, RefractiveIndex index, Direction wi) {
        HeightMap middle = middle(map);
        if (middle.relief() > DEEPEST) {
            return Optional.empty();
        }
        OrderSpectrum spectrum = new OrderSpectrum(middle);
        int steps = (int) Math.round((CieTable.MAXIMUM_WAVELENGTH - CieTable.MINIMUM_WAVELENGTH) / WAVELENGTH_STEP);
        return IntStream.rangeClosed(0, steps)
                .parallel()
                .mapToDouble(i -> CieTable.MINIMUM_WAVELENGTH + i * WAVELENGTH_STEP)
                .mapToObj(wavelength -> new EnergyBalance(spectrum.sum(index, wi, wavelength, 0), wavelength))
                .max(Comparator.comparingDouble(EnergyBalance::ratio));
    }

    /** Returns the middle {@value #MOST_SAMPLES} samples along each side of a larger scan. */
    static HeightMap middle(HeightMap map) {
        int columns = Math.min(MOST_SAMPLES, map.columns());
        int rows = Math.min(MOST_SAMPLES, map.rows());
        int left = (map.columns() - columns) / 2;
        int top = (map.rows() - rows) / 2;
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = map.at(left + i % columns, top + i / columns);
        }
        return new HeightMap(columns, rows, map.pitchX(), map.pitchY(), heights);
    }

    /** Returns a warning if the ratio exceeds {@link #LARGEST}, else empty. */
    public Optional<String> warning() {
        return ratio <= LARGEST
                ? Optional.empty()
                : Optional.of(Text.format(
                        "at %.0f nm the model reflects %.2f times the light of a mirror, because of orders near the horizon,"
                                + " where scalar theory does not conserve energy (docs/theory.md)",
                        wavelength * 1e9, ratio));
    }
}
