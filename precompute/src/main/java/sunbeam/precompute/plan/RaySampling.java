package sunbeam.precompute.plan;

import java.util.List;
import java.util.Locale;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ColorArrays;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/**
 * Sums a neighbourhood of bins, at wavelengths of Gauss's rule along the ray f = (u, v) / lambda: for orders that the
 * window neither resolves nor blurs, and for windows so large that a grid would not fit into memory
 * (shaders/method/full_rays.glsl).
 *
 * @param neighbourhood the bins
 * @param panel of Gauss's rule along the ray, cycles per metre
 * @param largestPanel in 1 / lambda, 1 / metres
 */
public record RaySampling(Neighbourhood neighbourhood, double panel, double largestPanel) implements Sampling {

    @Override
    public String summary(VisibleRange range) {
        return "%s at %d to %d wavelengths"
                .formatted(neighbourhood.summary(), GaussPanels.fewestNodes(largestPanel), mostNodes(range));
    }

    private int mostNodes(VisibleRange range) {
        return GaussPanels.nodes(largestPanel, panel, range.longestUv());
    }

    @Override
    public List<String> reasons(VisibleRange range) {
        return List.of(
                "spectrum: the window's is so narrow that its flanks lie bare between orders, or a grid would not fit into"
                        + " memory; " + neighbourhood.summary() + " are summed",
                String.format(
                        Locale.ROOT,
                        "wavelengths: by Gauss's rule of 4 on panels of %.4g cycles per metre along the ray (u, v) / lambda,"
                                + " %d or more",
                        panel,
                        GaussPanels.fewestNodes(largestPanel)));
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
                * Math.max(plan.expansion().terms(), neighbourhood.bins() + 2L * neighbourhood.radiusY() + 1);
    }

    @Override
    public List<ArrayLayout> layouts(Plan plan, MethodUse use) {
        List<ArrayLayout> layouts = BinArrays.layouts(plan);
        layouts.add(ColorArrays.cieWeightsLayout());
        return layouts;
    }

    @Override
    public ShaderTables tables(Plan plan, FourierTable table, MethodUse use, CieTable cie) {
        return BinArrays.tables("full_rays", plan, table, neighbourhood)
                .array(ColorArrays.cieWeights(cie))
                .reals("rayPanel", panel)
                .reals("rayLargestPanel", largestPanel)
                .reals("cieWhite", ColorArrays.cieWhite(cie))
                .build(plan.window().sigmaMetres(), plan.specularReach());
    }
}
