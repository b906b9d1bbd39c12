package sunbeam.precompute.analysis;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.TableArray;
import sunbeam.precompute.prepare.Edges;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Divisor of radiance that conserves energy: the light of all orders over that of a mirror of the same material, where it exceeds 1, by direction
 * of light and wavelength. It does not depend on the direction of view, so reciprocity is lost. The middle of a map
 * with many orders represents it. Thread-safe.
 */
public final class EnergyDivisor {
    private static final int LIGHTS = 24;
    // Nanometers of a cell: few orders have sharp peaks at the horizon, many a smooth sum.
    private static final int CELL_OF_FEW = 4;
    private static final int CELL_OF_MANY = 20;
    private static final long FEW_ORDERS = 5000;
    private static final double NANOMETER = 1e-9;
    // Sine of the light's angle; at 1 the irradiance is 0.
    private static final double LOWEST_LIGHT = 0.999;

    private final OrderSpectrum spectrum;
    private final RefractiveIndex index;
    private final double sigmaFrequency;
    private final int cell;

    public EnergyDivisor(HeightMap map, RefractiveIndex index, CoherenceWindow window) {
        this.index = index;
        HeightMap middle = EnergyBalance.middle(map);
        spectrum = new OrderSpectrum(middle);
        cell = OrderSpectrum.orders(middle) < FEW_ORDERS ? CELL_OF_FEW : CELL_OF_MANY;
        sigmaFrequency = window.sigmaFrequency();
    }

    /** Returns the divisor, at least 1; light in the patch's frame, wavelength in meters. */
    public double at(Direction wi, double wavelength) {
        return Math.max(1, spectrum.sum(index, wi, wavelength, sigmaFrequency));
    }

    /** Returns the weights over wavelength that divide colors under one direction of light. */
    public CieTable under(Direction wi, CieTable cie) {
        double[] divisors = IntStream.rangeClosed(0, cie.weighted().length - 1)
                .parallel()
                .mapToDouble(i -> at(wi, CieTable.MINIMUM_WAVELENGTH + i * NANOMETER))
                .toArray();
        return cie.times(wavelength ->
                1 / divisors[(int) Math.rint((wavelength - CieTable.MINIMUM_WAVELENGTH) / NANOMETER)]);
    }

    /** Returns one divisor for all wavelengths, which gives the luminance of all directions that exact ones give. */
    public double ofColors(Direction wi, CieTable cie) {
        double sent = 0;
        double conserved = 0;
        for (int first = 0; first < cie.weighted().length; first += cell) {
            double weight = 0;
            double moment = 0;
            for (int i = first; i < Math.min(first + cell, cie.weighted().length); i++) {
                weight += cie.weighted()[i][1];
                moment += cie.weighted()[i][1] * i;
            }
            if (weight > 0) {
                double wavelength = CieTable.MINIMUM_WAVELENGTH + moment / weight * NANOMETER;
                double ratio = spectrum.sum(index, wi, wavelength, sigmaFrequency);
                double mirror = weight * index.reflectance(wavelength, wi.z());
                sent += mirror * ratio;
                conserved += mirror * Math.min(1, ratio);
            }
        }
        return conserved > 0 ? sent / conserved : 1;
    }

    public static Direction light(double x, double y) {
        double outside = Math.max(1, Math.hypot(x, y) / LOWEST_LIGHT);
        return Direction.ofDisc(x / outside, y / outside);
    }

    /** Returns a shader's tables with 1 / {@link #ofColors} over the directions of light (shaders/include/gain.glsl). */
    public ShaderTables applyTo(ShaderTables tables, CieTable cie) {
        float[] shares = new float[LIGHTS * LIGHTS];
        IntStream.range(0, shares.length).parallel().forEach(i -> {
            int row = i / LIGHTS;
            double x = 2 * (i % LIGHTS + 0.5) / LIGHTS - 1;
            double y = 2 * (row + 0.5) / LIGHTS - 1;
            shares[i] = (float) (1 / ofColors(light(x, y), cie));
        });
        ArrayLayout layout = ArrayLayout.flat("energyShares", LIGHTS, LIGHTS, 1).linear();
        return tables.with(all -> all.define("ENERGY_CONSERVED", 1).array(TableArray.of(layout, shares)));
    }

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
                    .mapToObj(
                            wavelength -> new EnergyBalance(spectrum.sum(index, wi, wavelength, 0), wavelength, pitch))
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
            String words =
                    "at %.0f nm the model reflects %.2f times the light of a mirror, because of %sorders near the"
                            + " horizon, where scalar theory does not conserve energy (docs/theory.md)";
            return Optional.of(Text.format(words, wavelength * 1e9, ratio, cause))
                    .filter(large -> ratio > LARGEST);
        }
    }
}
