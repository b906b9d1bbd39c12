package sunbeam.precompute.plan;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ColorArrays;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/**
 * Sums a neighbourhood of bins, at wavelengths along the ray f = (u, v) / lambda: for orders that the
 * window neither resolves nor blurs, and for windows so large that a grid would not fit into memory
 * (shaders/method/full_rays.glsl).
 *
 * @param neighbourhood the bins
 * @param band the wavelengths
 */
public record RaySampling(Neighbourhood neighbourhood, BandRule band) implements Sampling {

    @Override
    public String wavelengths(VisibleRange range) {
        return Sampling.count(band.fewestNodes(), mostNodes(range)) + " wavelengths a pixel";
    }

    @Override
    public String summary(VisibleRange range) {
        return neighbourhood.summary() + " at " + Sampling.count(band.fewestNodes(), mostNodes(range)) + " wavelengths";
    }

    private int mostNodes(VisibleRange range) {
        return band.mostNodes(range.longestUv());
    }

    @Override
    public List<String> reasons(VisibleRange range) {
        return List.of(
                "spectrum: the window's is so narrow that its flanks lie bare between orders, or a grid would not fit into"
                        + " memory; " + neighbourhood.summary() + " are summed",
                "wavelengths: " + band.inWords());
    }

    @Override
    public int marginX(CoherenceWindow window, double width) {
        return neighbourhood.marginX();
    }

    @Override
    public int marginY(CoherenceWindow window, double height) {
        return neighbourhood.marginY();
    }

    @Override
    public long reads(Plan plan) {
        return mostNodes(plan.range()) * neighbourhood.reads(plan.expansion().terms());
    }

    @Override
    public long loopSteps(Plan plan) {
        return mostNodes(plan.range())
                * neighbourhood.loopSteps(plan.expansion().terms(), plan.average());
    }

    @Override
    public List<ArrayLayout> layouts(Plan plan, MethodUse use) {
        List<ArrayLayout> layouts = BinArrays.layouts(plan);
        layouts.add(ColorArrays.cieWeightsLayout());
        return layouts;
    }

    @Override
    public ShaderTables tables(Plan plan, FourierTable table, MethodUse use, CieTable cie) {
        ShaderTables.Builder tables = BinArrays.tables("full_rays", plan, table, neighbourhood);
        band.addTo(tables);
        return tables.array(ColorArrays.cieWeights(cie))
                .reals("cieWhite", ColorArrays.cieWhite(cie))
                .build(plan.window().sigmaMetres(), plan.specularReach());
    }
}
