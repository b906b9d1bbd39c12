package sunbeam.precompute.analysis;

import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.TableArray;

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
}
