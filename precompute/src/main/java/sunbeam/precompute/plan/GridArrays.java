package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.resample.AxisGrid;
import sunbeam.precompute.resample.Fields;
import sunbeam.precompute.resample.GridResampler;
import sunbeam.precompute.resample.GridResampler.Order;
import sunbeam.precompute.resample.PowerFields;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.shader.SpectrumArrays;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.shader.TermsLayout;
import sunbeam.precompute.table.FourierTable;

/** Arrays of shaders/method/grid_tables.glsl: the resampled spectra of one average. */
final class GridArrays {
    private static final int CHANNELS = TermsLayout.CHANNELS;

    private final GridSampling sampling;
    private final SpectrumPlan plan;
    private final Average average;
    private final String name;
    private final double sigma;
    private final double step;
    private final int taps;
    // Positions of columns along x and of rows along y; samples along rows and along columns.
    private final AxisGrid nodesX;
    private final AxisGrid nodesY;
    private final AxisGrid samplesX;
    private final AxisGrid samplesY;

    GridArrays(GridSampling sampling, SpectrumPlan plan, Average average) {
        this.sampling = sampling;
        this.plan = plan;
        this.average = average;
        this.name = ValueKind.name(average);
        double window = plan.window().sigmaFrequency();
        this.sigma = average == Average.COHERENT ? window : window / Math.sqrt(2);
        this.step = sigma / sampling.interpolation().deviation();
        this.taps = sampling.interpolation().taps();
        this.nodesX = plan.range().gridX(sampling.nodeStep(), 1);
        this.nodesY = plan.range().gridY(sampling.nodeStep(), 1);
        this.samplesX = plan.range().gridX(step, taps);
        this.samplesY = plan.range().gridY(step, taps);
    }

    /**
     * The ensemble has about twice as many terms as the expansion; these are real, four per texel, while two complex terms share a texel.
     */
    List<ArrayLayout> layouts(MethodUse use) {
        Expansion expansion = plan.expansion();
        int texels = (2 * expansion.terms() + CHANNELS - 1) / CHANNELS;
        int samples = CoefficientTable.sampleCount(expansion, average == Average.COHERENT ? 1 : PowerFields.BANDWIDTH);
        int functions = average == Average.COHERENT ? expansion.terms() : CHANNELS * texels;
        ArrayLayout coefficients = SpectrumArrays.coefficientsLayout(name + "Coefficients", samples, functions);
        List<ArrayLayout> layouts =
                new ArrayList<>(List.of(coefficients, pointLayout(texels, use).array()));
        if (use == MethodUse.COLOR) {
            raysLayouts(texels).forEach(rays -> layouts.add(rays.array()));
        }
        return layouts;
    }

    private TermsLayout pointLayout(int texels, MethodUse use) {
        VisibleRange range = pointRange(use);
        return TermsLayout.of(
                name + "Point",
                range.gridX(step, taps).count(),
                range.gridY(step, taps).count(),
                texels,
                1);
    }

    /** Returns the layouts of columns, which follow each other along x, and of rows: one texture for both, or two. */
    private List<TermsLayout> raysLayouts(int texels) {
        return sampling.apart()
                ? List.of(raysLayout("Columns", texels, 1), raysLayout("Rows", texels, 1))
                : List.of(raysLayout("Rays", texels, 2));
    }

    private TermsLayout raysLayout(String suffix, int texels, int grids) {
        return TermsLayout.of(
                name + suffix,
                Math.max(samplesX.count(), samplesY.count()),
                Math.max(nodesX.count(), nodesY.count()),
                texels,
                grids);
    }

    /** Both axes are interpolated in the whole range for single wavelengths, near the specular direction for colors. */
    private VisibleRange pointRange(MethodUse use) {
        VisibleRange range = plan.range();
        if (use == MethodUse.SPECTRAL) {
            return range;
        }
        double reach = sampling.centerReach();
        return new VisibleRange(-reach, reach, -reach, reach, range.minimumW(), range.maximumW());
    }

    void addTo(ShaderTables.Builder tables, FourierTable table, Fields fields, MethodUse use) {
        int texels = (fields.values().length + CHANNELS - 1) / CHANNELS;
        String prefix = name.toUpperCase(Locale.ROOT);
        TermsLayout point = pointLayout(texels, use);
        CoefficientTable coefficients = fields.coefficients();
        tables.define(prefix + "_TEXELS", texels)
                .define(prefix + "_POINT_TOGETHER", point.together())
                .array(SpectrumArrays.coefficients(name + "Coefficients", coefficients))
                .reals(name + "PhaseMap", SpectrumArrays.phaseMap(coefficients))
                .reals(name + "Scale", 1 / step);
        addPoint(tables, table, fields, point, use);
        if (use == MethodUse.COLOR) {
            List<TermsLayout> rays = raysLayouts(texels);
            tables.define(prefix + "_RAYS_TOGETHER", rays.get(0).together())
                    .define(prefix + "_RAYS_LAYERS", rays.get(0).layersPerGrid())
                    .define("RAYS_APART", rays.size() - 1);
            addRays(tables, table, fields, rays);
        }
    }

    private void addPoint(
            ShaderTables.Builder tables, FourierTable table, Fields fields, TermsLayout layout, MethodUse use) {
        AxisGrid pointX = pointRange(use).gridX(step, taps);
        AxisGrid pointY = pointRange(use).gridY(step, taps);
        GridResampler resampler = new GridResampler(
                GridResampler.Axis.forInterpolation(
                        pointX, table.bandX(), table.patch().width(), sampling.interpolation()),
                GridResampler.Axis.forInterpolation(
                        pointY, table.bandY(), table.patch().height(), sampling.interpolation()));
        tables.array(TableArray.computed(layout.array(), layer -> layer(fields, layer, layout, resampler, Order.ROWS)))
                .reals(name + "PointFirst", pointX.first(), pointY.first());
    }

    /** Adds the two grids for rays: columns at steps along x, and rows at steps along y. Each column or row is one row of a texture. */
    private void addRays(ShaderTables.Builder tables, FourierTable table, Fields fields, List<TermsLayout> layouts) {
        TermsLayout layout = layouts.get(0);
        double patchWidth = table.patch().width();
        double patchHeight = table.patch().height();
        GridResampler columns = new GridResampler(
                GridResampler.Axis.forGridPoints(
                        nodesX.extended(layout.array().height()), table.bandX(), patchWidth, sigma),
                GridResampler.Axis.forInterpolation(
                        samplesY.extended(layout.samples()), table.bandY(), patchHeight, sampling.interpolation()));
        GridResampler rows = new GridResampler(
                GridResampler.Axis.forInterpolation(
                        samplesX.extended(layout.samples()), table.bandX(), patchWidth, sampling.interpolation()),
                GridResampler.Axis.forGridPoints(
                        nodesY.extended(layout.array().height()), table.bandY(), patchHeight, sigma));
        int layers = layout.layersPerGrid();
        if (layouts.size() == 1) {
            tables.array(TableArray.computed(
                    layout.array(),
                    layer -> layer < layers
                            ? layer(fields, layer, layout, columns, Order.COLUMNS)
                            : layer(fields, layer - layers, layout, rows, Order.ROWS)));
        } else {
            tables.array(TableArray.computed(
                            layout.array(), layer -> layer(fields, layer, layout, columns, Order.COLUMNS)))
                    .array(TableArray.computed(
                            layouts.get(1).array(), layer -> layer(fields, layer, layout, rows, Order.ROWS)));
        }
        tables.reals("gridRayScale", 1 / step)
                .reals("gridRaysFirst", nodesX.first(), samplesY.first(), nodesY.first(), samplesX.first());
    }

    private static float[] layer(Fields fields, int layer, TermsLayout layout, GridResampler resampler, Order order) {
        int stride = CHANNELS * layout.together();
        float[] texels = new float[stride * resampler.size()];
        int first = stride * layer;
        double[][] together =
                Arrays.copyOfRange(fields.values(), first, Math.min(fields.values().length, first + stride));
        resampler.resample(together, texels, stride, order);
        return texels;
    }
}
