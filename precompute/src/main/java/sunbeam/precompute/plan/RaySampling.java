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
 * Sums a neighbourhood of bins, at wavelengths in equal steps along the ray f = (u, v) / lambda: for orders that the
 * window neither resolves nor blurs, and for windows so large that a grid would not fit into memory
 * (shaders/method/full_rays.glsl).
 *
 * @param neighbourhood the bins
 * @param nodeStep distance of the wavelengths along the ray, cycles per metre
 * @param fewestNodes wavelengths of directions whose ray is shorter than so many steps
 */
public record RaySampling(Neighbourhood neighbourhood, double nodeStep, int fewestNodes) implements Sampling {

    @Override
    public String wavelengths(VisibleRange range) {
        return "%d to %d wavelengths a pixel".formatted(fewestNodes, mostNodes(range));
    }

    @Override
    public String summary(VisibleRange range) {
        return "%s at %d to %d wavelengths".formatted(neighbourhood.summary(), fewestNodes, mostNodes(range));
    }

    private int mostNodes(VisibleRange range) {
        double longest = Math.sqrt(2) * range.maximumComponent();
        double waveNumbers = 1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH;
        return Math.max(fewestNodes, (int) Math.ceil(longest * waveNumbers / nodeStep) + 1);
    }

    @Override
    public List<String> reasons(VisibleRange range) {
        return List.of(
                "spectrum: the window's is so narrow that its flanks lie bare between orders, or a grid would not fit into"
                        + " memory; " + neighbourhood.summary() + " are summed",
                String.format(
                        Locale.ROOT,
                        "wavelengths: in steps of %.4g cycles per metre along the ray (u, v) / lambda, %d or more",
                        nodeStep,
                        fewestNodes));
    }

    @Override
    public int margin(CoherenceWindow window, double period) {
        return neighbourhood.margin();
    }

    @Override
    public long reads(Plan plan) {
        return mostNodes(plan.range()) * neighbourhood.reads(plan.expansion().terms());
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
                .reals("rayNodeStep", nodeStep)
                .integers("rayFewestNodes", fewestNodes)
                .reals("cieWhite", ColorArrays.cieWhite(cie))
                .build(plan.window().sigmaMetres(), plan.specularReach());
    }
}
