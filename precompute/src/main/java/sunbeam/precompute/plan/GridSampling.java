package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.plan.OrderSampling.BandRule;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.KernelPolynomials;
import sunbeam.precompute.shader.ShaderArrays;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.spectrum.InterpolationDesign;
import sunbeam.precompute.text.Text;

/**
 * Interpolates windowed spectra that were resampled onto grids. A direction's wavelengths are those at which its ray f = (u, v) / lambda
 * crosses a column (or row) of a grid: only the position along the column is interpolated (shaders/method/full_grid.glsl).
 *
 * @param nodeStep distance of columns and of rows, cycles per meter
 * @param longestStep longest step along a ray, cycles per meter; rays that cross many columns skip some
 * @param fewestNodes fewest wavelengths; where rays cross fewer columns, near the specular direction, both axes are interpolated
 * @param band rule for the wavelengths near the specular direction
 * @param spectral sampling for single wavelengths, of both averages; empty if it is this one
 * @param apart whether columns and rows are in separate textures, for drivers with smaller limits
 */
public record GridSampling(
        InterpolationDesign interpolation,
        Neighborhood neighborhood,
        double nodeStep,
        double longestStep,
        int fewestNodes,
        BandRule band,
        Optional<Sampling> spectral,
        boolean apart,
        ErrorBudget budget)
        implements Sampling {
    /** Returns the largest |u|, |v| up to which both axes are interpolated. */
    public double centerReach() {
        return fewestNodes * nodeStep / CieTable.BAND_WIDTH;
    }

    @Override
    public String summary(VisibleRange range) {
        return Text.format(
                "grid with %d taps, %s wavelengths",
                interpolation.taps(), Sampling.count(fewestNodes, mostNodes(range)));
    }

    private int mostNodes(VisibleRange range) {
        // At 45 degrees, where a ray takes the most steps; the last factor allows for rounding.
        int stride = (int) Math.max(1, longestStep * Math.sqrt(0.5) / nodeStep * (1 + 1e-6));
        double most = range.maximumComponent() * CieTable.BAND_WIDTH / (stride * nodeStep);
        return Math.max(fewestNodes, (int) Math.ceil(most));
    }

    @Override
    public long loopSteps(SpectrumPlan plan) {
        // Loops over the taps of a texel are unrolled, loops over texels may not be.
        long layers = (2L * plan.expansion().terms() + 3) / 4;
        double center = Math.sqrt(2) * Math.min(centerReach(), plan.range().maximumComponent());
        long nodes = Math.max(mostNodes(plan.range()), band.mostNodes(center));
        return nodes * layers;
    }

    private static List<Average> averages(SpectrumPlan plan, MethodUse use) {
        return use == MethodUse.SPECTRAL
                ? List.of(Average.COHERENT, Average.ENSEMBLE)
                : List.of(plan.area().average());
    }

    @Override
    public Sampling serving(MethodUse use) {
        return use == MethodUse.SPECTRAL ? spectral.orElse(this) : this;
    }

    @Override
    public List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use) {
        List<ArrayLayout> layouts = new ArrayList<>();
        for (Average average : averages(plan, use)) {
            layouts.addAll(new GridArrays(this, plan, average, use).layouts());
        }
        layouts.add(ShaderArrays.cieWeightsLayout());
        return layouts;
    }

    @Override
    public long workBytes(SpectrumPlan plan) {
        long bins = (long) plan.bandX().count() * plan.bandY().count();
        long turned = 2L * Double.BYTES * plan.expansion().terms() * bins;
        long layer = 0;
        for (MethodUse use : MethodUse.values()) {
            for (ArrayLayout layout : plan.layouts(use)) {
                layer = Math.max(layer, layout.bytes() / layout.layers());
            }
        }
        return 2 * turned + 2 * layer;
    }

    @Override
    public ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie) {
        ShaderTables.Builder tables = new ShaderTables.Builder("full_grid");
        plan.area().average().defineIn(tables);
        ShaderArrays.define(tables, true, table.terms());
        KernelPolynomials.of(interpolation.taps(), interpolation::kernel).defineIn(tables);
        // On rough patches the dim ends of cut orders need not be resolved.
        tables.define("COHERENT_TEXELS", 0)
                .define("ENSEMBLE_TEXELS", 0)
                .define("GRID_ENDS_CUT", budget.roughness().isRough() ? 0 : 1)
                .reals("heightHalfRange", table.expansion().scale().halfRange());
        for (Average average : averages(plan, use)) {
            new GridArrays(this, plan, average, use).addTo(tables, table);
        }
        tables.array(ShaderArrays.cieWeights(cie));
        if (use == MethodUse.COLOR) {
            band.addTo(tables);
            tables.reals("gridNodeStep", nodeStep)
                    .reals("gridLongestStep", longestStep / nodeStep * (1 + 1e-6))
                    .reals("gridCenterReach", centerReach())
                    .integers("gridFewestNodes", fewestNodes)
                    .reals("cieWhite", cie.white());
        }
        return tables.build(plan.window());
    }
}
