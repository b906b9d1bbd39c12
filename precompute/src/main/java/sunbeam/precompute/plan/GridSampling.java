package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.plan.Sampling.OrderSampling.BandRule;
import sunbeam.precompute.plan.ShaderArrays.KernelPolynomials;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.CoefficientTable;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.spectrum.InterpolationDesign;
import sunbeam.precompute.spectrum.InterpolationDesign.GridResampler;
import sunbeam.precompute.spectrum.InterpolationDesign.GridResampler.Axis;
import sunbeam.precompute.spectrum.InterpolationDesign.GridResampler.Order;
import sunbeam.precompute.spectrum.PowerSpectrum;
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
    private static final int CHANNELS = 4;

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
        return layers * Math.max(mostNodes(plan.range()), band.mostNodes(center));
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
            layouts.addAll(new GridArrays(plan, average, use).layouts());
        }
        layouts.add(ShaderArrays.cieWeightsLayout());
        return layouts;
    }

    @Override
    public long workBytes(SpectrumPlan plan) {
        long bins = (long) plan.bandX().count() * plan.bandY().count();
        long turned = 2L * Double.BYTES * plan.expansion().terms() * bins;
        long layer = Stream.of(MethodUse.values())
                .flatMap(use -> plan.layouts(use).stream())
                .mapToLong(layout -> layout.bytes() / layout.layers())
                .max()
                .orElseThrow();
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
            new GridArrays(plan, average, use).addTo(tables, table);
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

    /** Arrays of shaders/method/grid_tables.glsl: the resampled spectra of one average. */
    private final class GridArrays {
        private final SpectrumPlan plan;
        private final boolean coherent;
        private final String name;
        private final double sigma;
        private final double step;
        // Positions of columns along x and of rows along y; samples along rows and along columns.
        private final Grid nodes;
        private final Grid samples;
        private final Grid point;
        private final MethodUse use;

        private record Grid(Band x, Band y) {
            Grid(VisibleRange range, double step, int margin) {
                this(range.bandX(1 / step, margin), range.bandY(1 / step, margin));
            }
        }

        /** Real fields; {@code values} returns those from a first to before a last one, as {@code [field - first][bin]}. */
        private record Fields(
                CoefficientTable coefficients, int count, BiFunction<Integer, Integer, double[][]> values) {}

        GridArrays(SpectrumPlan plan, Average average, MethodUse use) {
            this.plan = plan;
            this.coherent = average == Average.COHERENT;
            this.name = ValueKind.name(average);
            this.sigma =
                    coherent ? plan.window().sigmaFrequency() : plan.window().sigmaFrequencyOfPower();
            this.step = sigma / interpolation.deviation();
            int taps = interpolation.taps();
            this.nodes = new Grid(plan.range(), nodeStep, 1);
            this.samples = new Grid(plan.range(), step, taps);
            this.use = use;
            // For colors both axes are interpolated near the specular direction only.
            double reach = centerReach();
            VisibleRange center = new VisibleRange(-reach, reach, -reach, reach, 0, 0);
            this.point = new Grid(use == MethodUse.SPECTRAL ? plan.range() : center, step, taps);
        }

        /** The ensemble has about twice as many terms as the expansion, real ones, four per texel; two complex terms share a texel. */
        List<ArrayLayout> layouts() {
            int terms = plan.expansion().terms();
            int texels = texels(2 * terms);
            int samples = CoefficientTable.sampleCount(plan.expansion(), coherent ? 1 : PowerSpectrum.BANDWIDTH);
            List<ArrayLayout> layouts = new ArrayList<>();
            layouts.add(ShaderArrays.coefficientsLayout(
                    name + "Coefficients", samples, coherent ? terms : CHANNELS * texels));
            layouts(texels).forEach(layout -> layouts.add(layout.array()));
            return layouts;
        }

        private static int texels(int fields) {
            return (fields + CHANNELS - 1) / CHANNELS;
        }

        /** Returns the layout of the points' texture and, for colors, of the rays' one or two. */
        private List<TermsLayout> layouts(int texels) {
            TermsLayout points = TermsLayout.of(name + "Point", point.x.count(), point.y.count(), texels, 1);
            if (use == MethodUse.SPECTRAL) {
                return List.of(points);
            }
            return apart
                    ? List.of(points, raysLayout("Columns", texels, 1), raysLayout("Rows", texels, 1))
                    : List.of(points, raysLayout("Rays", texels, 2));
        }

        private TermsLayout raysLayout(String suffix, int texels, int grids) {
            return TermsLayout.of(
                    name + suffix,
                    Math.max(samples.x.count(), samples.y.count()),
                    Math.max(nodes.x.count(), nodes.y.count()),
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
            PowerSpectrum spectrum = PowerSpectrum.of(table, budget.powerBasis());
            return new Fields(spectrum.coefficients(), spectrum.coefficients().terms(), spectrum::terms);
        }

        void addTo(ShaderTables.Builder tables, FourierTable table) {
            Fields fields = fields(table);
            int texels = texels(fields.count);
            String prefix = name.toUpperCase(Locale.ROOT);
            List<TermsLayout> layouts = layouts(texels);
            TermsLayout layout = layouts.get(0);
            GridResampler points =
                    new GridResampler(interpolated(point.x, table.x()), interpolated(point.y, table.y()));
            tables.define(prefix + "_TEXELS", texels)
                    .define(prefix + "_POINT_TOGETHER", layout.together())
                    .array(ShaderArrays.coefficients(name + "Coefficients", fields.coefficients))
                    .reals(name + "PhaseMap", ShaderArrays.phaseMap(fields.coefficients))
                    .reals(name + "Scale", 1 / step)
                    .array(TableArray.computed(
                            layout.array(), layer -> layer(fields, layer, layout, points, Order.ROWS)))
                    .reals(name + "PointFirst", point.x.first(), point.y.first());
            if (layouts.size() > 1) {
                List<TermsLayout> rays = layouts.subList(1, layouts.size());
                tables.define(prefix + "_RAYS_TOGETHER", rays.get(0).together())
                        .define(prefix + "_RAYS_LAYERS", rays.get(0).layersPerGrid())
                        .define("RAYS_APART", rays.size() - 1);
                addRays(tables, table, fields, rays);
            }
        }

        private Axis interpolated(Band grid, PowerSpectrum.Axis bins) {
            return Axis.forInterpolation(grid, step, bins, interpolation);
        }

        private Axis nodes(Band grid, PowerSpectrum.Axis bins) {
            return Axis.forGridPoints(grid, nodeStep, bins, sigma);
        }

        /** Adds columns at steps along x, and rows at steps along y. Each column or row is one row of a texture. */
        private void addRays(
                ShaderTables.Builder tables, FourierTable table, Fields fields, List<TermsLayout> layouts) {
            TermsLayout layout = layouts.get(0);
            int height = layout.array().height();
            GridResampler columns = new GridResampler(
                    nodes(nodes.x.extended(height), table.x()),
                    interpolated(samples.y.extended(layout.samples()), table.y()));
            GridResampler rows = new GridResampler(
                    interpolated(samples.x.extended(layout.samples()), table.x()),
                    nodes(nodes.y.extended(height), table.y()));
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
                    .reals("gridRaysFirst", nodes.x.first(), samples.y.first(), nodes.y.first(), samples.x.first());
        }

        private static float[] layer(
                Fields fields, int layer, TermsLayout layout, GridResampler resampler, Order order) {
            int stride = CHANNELS * layout.together();
            float[] texels = new float[stride * resampler.size()];
            int first = stride * layer;
            double[][] values = fields.values.apply(first, Math.min(fields.count, first + stride));
            resampler.resample(values, texels, stride, order);
            return texels;
        }
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
