package sunbeam.precompute.plan;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ColorArrays;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.spectrum.FourierTable;

/**
 * Sums the DFT bins around frequencies f = (u, v) / lambda on a direction's ray, each bin a diffraction order of the repeated patch: for
 * small and periodic patches, where few bins count (shaders/method/full_orders.glsl).
 *
 * @param resolved wavelengths around the middle of each order, which is integrated by itself; empty if orders overlap
 * @param band wavelengths of the whole band, for overlapping orders and for the specular one, which has no middle
 */
public record OrderSampling(Neighborhood neighborhood, Optional<OrderNodes> resolved, BandRule band)
        implements Sampling {

    /**
     * Wavelengths around the middle of an order.
     *
     * @param reach distance of the farthest wavelength from the order's middle, in standard deviations of the order's power
     * @param spacing distance of wavelengths, in deviations
     * @param panel size of a panel of Gauss's rule on orders that the visible band cuts, in deviations
     * @param largestStep largest step of the wavelength, meters; limits the steps in orders near the specular one, which are broader than
     *     details of D65 and of the color matching functions
     * @param cornerLength largest ratio of a squared step to the order's deviation, meters; resolves a corner of D65's table within the
     *     order
     */
    public record OrderNodes(double reach, double spacing, double panel, double largestStep, double cornerLength) {
        private int fewest() {
            return 2 * (int) Math.ceil(reach / spacing) + 1;
        }
    }

    /** Returns the sampling for a patch so small that the window resolves each of its orders: the bin nearest to a frequency suffices. */
    static OrderSampling resolved(OrderNodes nodes, BandRule band) {
        return new OrderSampling(new Neighborhood(0, Neighborhood.Anchor.NEAREST), Optional.of(nodes), band);
    }

    @Override
    public String summary(VisibleRange range) {
        return resolved.map(nodes -> "single orders with " + nodes.fewest() + " wavelengths each or more")
                .orElseGet(() -> neighborhood.summary() + " at "
                        + Sampling.count(band.fewestNodes(), band.mostNodes(range.longestUv())) + " wavelengths");
    }

    @Override
    public Neighborhood around(CoherenceWindow window, HeightMap map) {
        return neighborhood;
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
        List<ArrayLayout> layouts = BinArrays.layouts(plan);
        layouts.add(ColorArrays.cieWeightsLayout());
        return layouts;
    }

    @Override
    public ShaderTables tables(SpectrumPlan plan, FourierTable table, MethodUse use, CieTable cie) {
        ShaderTables.Builder tables = BinArrays.tables("full_orders", plan, table, neighborhood);
        band.addTo(tables);
        tables.array(ColorArrays.cieWeights(cie))
                .reals("cieWhite", cie.white())
                .reals("windowSigmaFrequency", plan.window().sigmaFrequency())
                .define("ORDERS_RESOLVED", resolved.isPresent() ? 1 : 0);
        resolved.ifPresent(nodes -> tables.reals("orderReach", nodes.reach())
                .reals("orderNodeSpacing", nodes.spacing())
                .reals("orderPanel", nodes.panel())
                .reals("orderLargestStep", nodes.largestStep())
                .reals("orderCornerLength", nodes.cornerLength()));
        return tables.build(plan.window().sigmaMeters(), plan.specularReach());
    }
}
