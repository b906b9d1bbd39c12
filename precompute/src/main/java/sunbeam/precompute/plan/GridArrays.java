package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderArrays;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.CoefficientTable;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.spectrum.GridResampler;
import sunbeam.precompute.spectrum.GridResampler.Axis;
import sunbeam.precompute.spectrum.GridResampler.Order;
import sunbeam.precompute.spectrum.PowerSpectrum;

/** Arrays of shaders/method/grid_tables.glsl: the resampled spectra of one average. */
final class GridArrays {
    private static final int CHANNELS = 4;

    private final GridSampling sampling;
    private final SpectrumPlan plan;
    private final boolean coherent;
    private final String name;
    private final double sigma;
    private final double step;
    // Positions of columns along x and of rows along y; samples along rows and along columns.
    private final Band nodesX;
    private final Band nodesY;
    private final Band samplesX;
    private final Band samplesY;
    private final Band pointX;
    private final Band pointY;
    private final MethodUse use;

    /** Real fields; the function returns {@code [field - first][bin]} from a first field to an end. */
    private record Fields(CoefficientTable coefficients, int count, BiFunction<Integer, Integer, double[][]> values) {}

    GridArrays(GridSampling sampling, SpectrumPlan plan, Average average, MethodUse use) {
        this.sampling = sampling;
        this.plan = plan;
        this.coherent = average == Average.COHERENT;
        this.name = ValueKind.name(average);
        double window = plan.window().sigmaFrequency();
        this.sigma = coherent ? window : window / Math.sqrt(2);
        this.step = sigma / sampling.interpolation().deviation();
        int taps = sampling.interpolation().taps();
        this.nodesX = plan.range().bandX(1 / sampling.nodeStep(), 1);
        this.nodesY = plan.range().bandY(1 / sampling.nodeStep(), 1);
        this.samplesX = plan.range().bandX(1 / step, taps);
        this.samplesY = plan.range().bandY(1 / step, taps);
        this.use = use;
        // Both axes are interpolated in the whole range for single wavelengths, near the specular direction for colors.
        double reach = sampling.centerReach();
        VisibleRange point =
                use == MethodUse.SPECTRAL ? plan.range() : new VisibleRange(-reach, reach, -reach, reach, 0, 0);
        this.pointX = point.bandX(1 / step, taps);
        this.pointY = point.bandY(1 / step, taps);
    }

    /** The ensemble has about twice as many terms as the expansion, real ones, four per texel; two complex terms share a texel. */
    List<ArrayLayout> layouts() {
        int terms = plan.expansion().terms();
        int texels = texels(2 * terms);
        int samples = CoefficientTable.sampleCount(plan.expansion(), coherent ? 1 : PowerSpectrum.BANDWIDTH);
        int functions = coherent ? terms : CHANNELS * texels;
        List<ArrayLayout> layouts = new ArrayList<>(List.of(
                ShaderArrays.coefficientsLayout(name + "Coefficients", samples, functions),
                pointLayout(texels).array()));
        if (use == MethodUse.COLOR) {
            raysLayouts(texels).forEach(rays -> layouts.add(rays.array()));
        }
        return layouts;
    }

    private static int texels(int fields) {
        return (fields + CHANNELS - 1) / CHANNELS;
    }

    private TermsLayout pointLayout(int texels) {
        return TermsLayout.of(name + "Point", pointX.count(), pointY.count(), texels, 1);
    }

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

    private Fields fields(FourierTable table) {
        if (coherent) {
            return new Fields(
                    CoefficientTable.sampled(table.expansion()),
                    2 * table.terms(),
                    (first, end) ->
                            table.amplitudes(first / 2, end / 2, plan.area().origin()));
        }
        PowerSpectrum spectrum = PowerSpectrum.of(table, sampling.budget().powerBasis());
        return new Fields(spectrum.coefficients(), spectrum.coefficients().terms(), spectrum::terms);
    }

    void addTo(ShaderTables.Builder tables, FourierTable table) {
        Fields fields = fields(table);
        CoefficientTable coefficients = fields.coefficients;
        int texels = texels(fields.count);
        String prefix = name.toUpperCase(Locale.ROOT);
        TermsLayout point = pointLayout(texels);
        GridResampler points = new GridResampler(interpolated(pointX, table.x()), interpolated(pointY, table.y()));
        tables.define(prefix + "_TEXELS", texels)
                .define(prefix + "_POINT_TOGETHER", point.together())
                .array(ShaderArrays.coefficients(name + "Coefficients", coefficients))
                .reals(name + "PhaseMap", ShaderArrays.phaseMap(coefficients))
                .reals(name + "Scale", 1 / step)
                .array(TableArray.computed(point.array(), layer -> layer(fields, layer, point, points, Order.ROWS)))
                .reals(name + "PointFirst", pointX.first(), pointY.first());
        if (use == MethodUse.COLOR) {
            List<TermsLayout> rays = raysLayouts(texels);
            tables.define(prefix + "_RAYS_TOGETHER", rays.get(0).together())
                    .define(prefix + "_RAYS_LAYERS", rays.get(0).layersPerGrid())
                    .define("RAYS_APART", rays.size() - 1);
            addRays(tables, table, fields, rays);
        }
    }

    private Axis interpolated(Band grid, PowerSpectrum.Axis bins) {
        return Axis.forInterpolation(grid, step, bins, sampling.interpolation());
    }

    private Axis nodes(Band grid, PowerSpectrum.Axis bins) {
        return Axis.forGridPoints(grid, sampling.nodeStep(), bins, sigma);
    }

    /** Adds columns at steps along x, and rows at steps along y. Each column or row is one row of a texture. */
    private void addRays(ShaderTables.Builder tables, FourierTable table, Fields fields, List<TermsLayout> layouts) {
        TermsLayout layout = layouts.get(0);
        int height = layout.array().height();
        GridResampler columns = new GridResampler(
                nodes(nodesX.extended(height), table.x()),
                interpolated(samplesY.extended(layout.samples()), table.y()));
        GridResampler rows = new GridResampler(
                interpolated(samplesX.extended(layout.samples()), table.x()),
                nodes(nodesY.extended(height), table.y()));
        // The layers of all columns precede those of all rows.
        int layers = layout.layersPerGrid();
        IntFunction<float[]> rays = layer -> layer < layers
                ? layer(fields, layer, layout, columns, Order.COLUMNS)
                : layer(fields, layer - layers, layout, rows, Order.ROWS);
        tables.array(TableArray.computed(layout.array(), rays));
        if (layouts.size() == 2) {
            tables.array(TableArray.computed(layouts.get(1).array(), layer -> rays.apply(layers + layer)));
        }
        tables.reals("gridRayScale", 1 / step)
                .reals("gridRaysFirst", nodesX.first(), samplesY.first(), nodesY.first(), samplesX.first());
    }

    private static float[] layer(Fields fields, int layer, TermsLayout layout, GridResampler resampler, Order order) {
        int stride = CHANNELS * layout.together();
        float[] texels = new float[stride * resampler.size()];
        int first = stride * layer;
        double[][] values = fields.values.apply(first, Math.min(fields.count, first + stride));
        resampler.resample(values, texels, stride, order);
        return texels;
    }

    /**
     * Layout of a spectrum's terms in a texture. The texels of one sample lie side by side in a row, {@code together} in a layer, so that a
     * pixel's reads are adjacent; others, beyond the limits of a row and of Java's heap, are in further layers.
     */
    record TermsLayout(int texels, int together, ArrayLayout array) {
        // Limit of a layer, which is computed in the heap at a time.
        private static final long LARGEST_LAYER_BYTES = 1L << 28;

        static TermsLayout of(String sampler, int samples, int rows, int texels, int grids) {
            long bytes = (long) Float.BYTES * CHANNELS * samples * rows;
            long most = Math.min(MemoryNeed.LONGEST_SIDE / samples, LARGEST_LAYER_BYTES / bytes);
            int together = (int) Math.max(1, Math.min(texels, most));
            int layers = (texels + together - 1) / together;
            return new TermsLayout(
                    texels, together, ArrayLayout.layered(sampler, samples * together, rows, grids * layers, CHANNELS));
        }

        int layersPerGrid() {
            return (texels + together - 1) / together;
        }

        int samples() {
            return array.width() / together;
        }
    }
}
