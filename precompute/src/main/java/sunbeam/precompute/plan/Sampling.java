package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.CoefficientTable;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.text.Text;

/** Rule for evaluating the windowed spectrum: the bins or grids to read, and the wavelengths. */
public sealed interface Sampling permits Sampling.BinSampling, Sampling.OrderSampling, GridSampling {
    // Per pixel: Mesa's software renderer silently ends all loops after 65,535 (shaders/include/loops.glsl).
    long MOST_LOOP_STEPS = 60_000;

    String summary(VisibleRange range);

    /** Formats a range of numbers: "60 to 166", or one number. */
    static String count(int fewest, int most) {
        return fewest == most ? Integer.toString(fewest) : fewest + " to " + most;
    }

    Neighborhood neighborhood();

    /** Returns the loop steps of the slowest pixel; unrolled loops do not count. */
    long loopSteps(SpectrumPlan plan);

    default Sampling serving(MethodUse use) {
        return this;
    }

    /** Returns the shapes of the arrays of {@link #tables}, with an upper limit of layers where unknown. */
    List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use);

    /** Returns the bytes of heap that computing the arrays takes beside the Fourier table. */
    default long workBytes(SpectrumPlan plan) {
        return 0;
    }

    /** Returns the shader's tables, with layers computed on demand; the Fourier table may have fewer terms than the plan. */
    ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie);

    /**
     * Sum over a neighborhood of bins at fixed wavelengths (shaders/method/full_bins.glsl): planned with exact weights for any light, or of
     * equal steps, as in the thesis, which keep no tolerance.
     */
    record BinSampling(Neighborhood neighborhood, WavelengthNodes wavelengths, boolean planned) implements Sampling {
        private static final double THESIS_WAVELENGTH_STEP = 5e-9;
        // Most bins of a neighborhood whose shader sums terms in the outer loop and bins in the inner one.
        private static final int FEW_BINS = 81;
        private static final String TERMS = "tableTerms";
        private static final String COEFFICIENTS = "expansionCoefficients";

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
        public long loopSteps(SpectrumPlan plan) {
            return wavelengths.count() * neighborhood.loopSteps();
        }

        @Override
        public List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use) {
            List<ArrayLayout> layouts = binLayouts(plan);
            layouts.add(ShaderArrays.wavelengthsLayout(wavelengths));
            return layouts;
        }

        @Override
        public ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie) {
            return binTables("full_bins", plan, table, neighborhood)
                    .array(ShaderArrays.wavelengths(wavelengths))
                    .integers("wavelengthCount", wavelengths.count())
                    .build(plan.window());
        }

        /** Part of cache keys: for a given light, the number of wavelengths and the first two determine all. */
        @Override
        public String toString() {
            return "BinSampling[" + neighborhood + ", " + wavelengths.count() + " wavelengths from "
                    + wavelengths.wavelengths()[0] + ", "
                    + wavelengths.wavelengths()[Math.min(1, wavelengths.count() - 1)]
                    + "]";
        }

        static List<ArrayLayout> binLayouts(SpectrumPlan plan) {
            List<ArrayLayout> layouts = new ArrayList<>();
            Expansion expansion = plan.expansion();
            layouts.add(terms(plan.bandX(), plan.bandY(), expansion.terms()));
            if (expansion.kind() != Expansion.Kind.TAYLOR) {
                int samples = CoefficientTable.sampleCount(expansion, 1);
                layouts.add(ShaderArrays.singleLayout(COEFFICIENTS, samples, expansion.terms()));
            }
            return layouts;
        }

        private static ArrayLayout terms(Band bandX, Band bandY, int terms) {
            return ArrayLayout.layered(TERMS, bandX.count(), bandY.count(), terms, 2);
        }

        /** Returns arrays and constants of shaders/method/neighborhood.glsl. */
        static ShaderTables.Builder binTables(
                String shader, SpectrumPlan plan, FourierTable table, Neighborhood neighborhood) {
            Expansion expansion = table.expansion();
            boolean sampled = expansion.kind() != Expansion.Kind.TAYLOR;
            ShaderTables.Builder tables = new ShaderTables.Builder(shader);
            plan.area().average().defineIn(tables);
            ShaderArrays.define(tables, sampled, table.terms());
            tables.array(TableArray.computed(
                            terms(table.bandX(), table.bandY(), table.terms()),
                            n -> interleaved(
                                    table.amplitudes(n, n + 1, plan.area().origin()))))
                    .integers("tableFirst", table.bandX().first(), table.bandY().first())
                    .reals("heightHalfRange", expansion.scale().halfRange());
            if (sampled) {
                CoefficientTable coefficients = CoefficientTable.sampled(expansion);
                tables.array(ShaderArrays.singleCoefficients(COEFFICIENTS, coefficients))
                        .reals("expansionPhaseMap", ShaderArrays.phaseMap(coefficients));
            }
            // The outer loop then runs over the terms; its steps count, since compilers need not unroll it.
            long steps = expansion.terms() * plan.sampling().loopSteps(plan);
            boolean few = neighborhood.bins() <= FEW_BINS && steps <= MOST_LOOP_STEPS;
            tables.define("ANCHOR_FLOOR", 0)
                    .define("ANCHOR_NEAREST", 1)
                    .define("ANCHOR", "ANCHOR_" + neighborhood.anchor())
                    .define("RADIUS", Text.format("ivec2(%d, %d)", neighborhood.radiusX(), neighborhood.radiusY()))
                    .define("FEW_BINS", few ? 1 : 0)
                    .integers("tableRadius", neighborhood.radiusX(), neighborhood.radiusY());
            double sigma = plan.window().sigmaFrequency();
            double width = table.map().width();
            double height = table.map().height();
            return tables.reals("tablePeriod", width, height)
                    .reals("tablePeriodRest", width - (float) width, height - (float) height)
                    .reals("windowSigmaBins", sigma * width, sigma * height);
        }

        private static float[] interleaved(double[][] parts) {
            float[] result = new float[2 * parts[0].length];
            for (int i = 0; i < parts[0].length; i++) {
                result[2 * i] = (float) parts[0][i];
                result[2 * i + 1] = (float) parts[1][i];
            }
            return result;
        }
    }

    /**
     * Sums the DFT bins around frequencies f = (u, v) / lambda on a direction's ray, each bin a diffraction order of the repeated patch: for
     * small and periodic patches, where few bins count (shaders/method/full_orders.glsl).
     *
     * @param resolved wavelengths around each order's middle, to integrate it by itself; empty if orders overlap
     * @param band wavelengths of the whole band, for overlapping orders and for the specular one, which has no middle
     */
    record OrderSampling(Neighborhood neighborhood, Optional<OrderNodes> resolved, BandRule band) implements Sampling {
        /**
         * Wavelengths around the middle of an order; lengths are standard deviations of the order's power unless stated.
         *
         * @param reach distance of the farthest wavelength from the middle
         * @param panel size of a panel of Gauss's rule on orders that the visible band cuts
         * @param largestStep largest step of the wavelength, meters: orders near the specular one are broader than details of D65 and of the
         *     color matching functions
         * @param cornerLength largest ratio of a squared step to the deviation, meters; resolves a corner of D65's table
         */
        public record OrderNodes(double reach, double spacing, double panel, double largestStep, double cornerLength) {
            private int fewest() {
                return 2 * (int) Math.ceil(reach / spacing) + 1;
            }
        }

        /**
         * Quadrature rule over the wavelengths of a ray f = (u, v) / lambda, for orders that the visible band cuts
         * (shaders/include/integral.glsl). Short rays get equal steps of 1 / lambda with Gregory's end corrections, which suit the kinks of
         * D65's table best; longer ones, which cross narrower orders, panels of Gauss's rule.
         *
         * @param reach |(u, v)| up to which equal steps resolve the orders
         * @param panel size of a panel along the ray, cycles per meter
         * @param largestPanel largest size of a panel in 1 / lambda, 1 / meters
         */
        public record BandRule(int fewestNodes, double reach, double panel, double largestPanel) {
            private static final int NODES_PER_PANEL = 4;
            // Panels of one step at both ends, subdivided.
            private static final int GRADED_PANELS = 4;
            // Per equal step: with one, the kinks of D65's table, which lie anywhere in a panel, cost more.
            private static final double GAUSS_NODES_PER_STEP = 2;
            // Where the band cuts off an order's middle, only its flank is left, which falls this much faster.
            private static final double STEEPEST_FLANK = 2;

            /** Deviation of an order's power along the ray, cycles per meter; spacing of equal steps and panel size, in deviations. */
            static BandRule of(int fewestNodes, double deviation, double spacing, double panel) {
                return new BandRule(
                        fewestNodes,
                        fewestNodes * spacing * deviation / CieTable.BAND_WIDTH / STEEPEST_FLANK,
                        panel * deviation,
                        CieTable.BAND_WIDTH * NODES_PER_PANEL / (GAUSS_NODES_PER_STEP * fewestNodes));
            }

            /** Returns the rule for a rough patch, where no order stands alone at the band's ends: steps need only resolve an order. */
            BandRule withEqualSteps(double step) {
                return new BandRule(fewestNodes, fewestNodes * step / CieTable.BAND_WIDTH, panel, largestPanel);
            }

            int nodes(double uv) {
                if (uv <= reach) {
                    return fewestNodes;
                }
                double equal = Math.max(2, Math.ceil(CieTable.BAND_WIDTH / Math.min(largestPanel, panel / uv) - 1e-3));
                return NODES_PER_PANEL * ((int) equal + GRADED_PANELS);
            }

            int mostNodes(double longestUv) {
                return Math.max(fewestNodes, nodes(longestUv));
            }

            void addTo(ShaderTables.Builder tables) {
                tables.integers("bandFewestNodes", fewestNodes)
                        .reals("bandReach", reach)
                        .reals("bandPanel", panel)
                        .reals("bandLargestPanel", largestPanel);
            }
        }

        @Override
        public String summary(VisibleRange range) {
            return resolved.map(nodes -> "single orders with " + nodes.fewest() + " wavelengths each or more")
                    .orElseGet(() -> neighborhood.summary() + " at "
                            + Sampling.count(band.fewestNodes(), band.mostNodes(range.longestUv())) + " wavelengths");
        }

        @Override
        public long loopSteps(SpectrumPlan plan) {
            // A ray starts at the specular order and passes at most half of the orders along each axis.
            long passed = ((long) plan.bandX().count() + plan.bandY().count()) / 2;
            return resolved.map(nodes -> passed * nodes.fewest())
                    .orElseGet(() -> band.mostNodes(plan.range().longestUv()) * neighborhood.loopSteps());
        }

        @Override
        public List<ArrayLayout> layouts(SpectrumPlan plan, MethodUse use) {
            List<ArrayLayout> layouts = BinSampling.binLayouts(plan);
            layouts.add(ShaderArrays.cieWeightsLayout());
            return layouts;
        }

        @Override
        public ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie) {
            ShaderTables.Builder tables = BinSampling.binTables("full_orders", plan, table, neighborhood);
            band.addTo(tables);
            tables.array(ShaderArrays.cieWeights(cie))
                    .reals("cieWhite", cie.white())
                    .reals("windowSigmaFrequency", plan.window().sigmaFrequency())
                    .define("ORDERS_RESOLVED", resolved.isPresent() ? 1 : 0);
            resolved.ifPresent(nodes -> tables.reals("orderReach", nodes.reach())
                    .reals("orderNodeSpacing", nodes.spacing())
                    .reals("orderPanel", nodes.panel())
                    .reals("orderLargestStep", nodes.largestStep())
                    .reals("orderCornerLength", nodes.cornerLength()));
            return tables.build(plan.window());
        }
    }
}
