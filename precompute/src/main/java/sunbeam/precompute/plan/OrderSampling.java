package sunbeam.precompute.plan;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderArrays;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.FourierTable;

/**
 * Sums the DFT bins around frequencies f = (u, v) / lambda on a direction's ray, each bin a diffraction order of the repeated patch: for
 * small and periodic patches, where few bins count (shaders/method/full_orders.glsl).
 *
 * @param resolved wavelengths around each order's middle, to integrate it by itself; empty if orders overlap
 * @param band wavelengths of the whole band, for overlapping orders and for the specular one, which has no middle
 */
public record OrderSampling(Neighborhood neighborhood, Optional<OrderNodes> resolved, BandRule band)
        implements Sampling {
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
