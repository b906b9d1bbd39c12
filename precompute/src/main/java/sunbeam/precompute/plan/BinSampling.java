package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ColorArrays;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.FourierTable;

/**
 * Sum over a neighborhood of bins at fixed wavelengths for all directions (shaders/method/full_bins.glsl): equal steps, as in the thesis,
 * or exact weights for light with spectral lines.
 *
 * @param planned whether the wavelengths keep the tolerance; false if the user chose them
 */
public record BinSampling(Neighborhood neighborhood, WavelengthNodes wavelengths, boolean planned) implements Sampling {
    private static final double THESIS_WAVELENGTH_STEP = 5e-9;

    /**
     * Returns a sum over all bins that count, at wavelengths with exact weights for any light.
     *
     * @param widestStep largest step in 1 / lambda, 1 / meters, that resolves the diffracted power
     */
    static BinSampling exact(Neighborhood neighborhood, CieTable cie, double widestStep) {
        return new BinSampling(neighborhood, WavelengthNodes.integrated(cie, widestStep), true);
    }

    /** Returns the sum that the user chose; by default with the thesis's wavelength step and all bins that count. */
    static BinSampling of(TableChoices table, CoherenceWindow window, HeightMap map, CieTable cie) {
        double sigmaBins = window.sigmaFrequency() * Math.max(map.width(), map.height());
        int radius = new ErrorBudget(table.tolerance()).neighborhoodRadius(sigmaBins);
        return new BinSampling(
                table.neighborhood().orElse(new Neighborhood(radius, Neighborhood.Anchor.NEAREST)),
                WavelengthNodes.uniform(cie, table.wavelengthStep().orElse(THESIS_WAVELENGTH_STEP)),
                false);
    }

    @Override
    public String summary(VisibleRange range) {
        return neighborhood.summary() + " at " + wavelengths.count() + " wavelengths";
    }

    @Override
    public Neighborhood around(CoherenceWindow window, HeightMap map) {
        return neighborhood;
    }

    @Override
    public long loopSteps(SpectrumPlan plan) {
        return wavelengths.count() * neighborhood.loopSteps();
    }

    @Override
    public List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use) {
        List<ArrayLayout> layouts = BinArrays.layouts(plan);
        layouts.add(ColorArrays.wavelengthsLayout(wavelengths));
        return layouts;
    }

    @Override
    public ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie) {
        return BinArrays.tables("full_bins", plan, table, neighborhood)
                .array(ColorArrays.wavelengths(wavelengths))
                .integers("wavelengthCount", wavelengths.count())
                .build(plan.window().sigmaMeters(), plan.specularReach());
    }

    /** Part of cache keys: for a given light, the number of wavelengths and the first two determine all. */
    @Override
    public String toString() {
        return "BinSampling[" + neighborhood + ", " + wavelengths.count() + " wavelengths from "
                + wavelengths.wavelengths()[0] + ", " + wavelengths.wavelengths()[Math.min(1, wavelengths.count() - 1)]
                + "]";
    }
}
