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
import sunbeam.precompute.units.Lengths;

/**
 * Looks at the nearest bin only, at wavelengths placed around the middle of each order that a direction sees: for patches
 * so small that the window resolves every order (shaders/method/full_orders.glsl).
 *
 * @param reach how far from an order's middle wavelengths lie, in standard deviations of the order's power
 * @param nodeSpacing their distance, likewise
 * @param panel of Gauss's rule on orders that the visible band cuts, likewise
 * @param largestStep their largest distance in metres: orders near the specular one are broader than the structure of the
 *     colour matching functions and D65
 * @param cornerLength square of a step over the order's deviation, metres: at most this, so that a corner of D65's table within the
 *     order is resolved
 * @param band wavelengths within the specular order, which has no middle
 */
public record OrderSampling(
        double reach, double nodeSpacing, double panel, double largestStep, double cornerLength, BandRule band)
        implements Sampling {
    private static final Neighbourhood NEAREST_BIN = new Neighbourhood(0, Neighbourhood.Anchor.NEAREST);

    @Override
    public String wavelengths(VisibleRange range) {
        return String.format(Locale.ROOT, "%d wavelengths or more for each order", nodes());
    }

    @Override
    public String summary(VisibleRange range) {
        return String.format(Locale.ROOT, "single orders with %d wavelengths each or more", nodes());
    }

    private int nodes() {
        return 2 * (int) Math.ceil(reach / nodeSpacing) + 1;
    }

    @Override
    public List<String> reasons(VisibleRange range) {
        return List.of(
                "spectrum: the patch is so small that the window resolves every order; the nearest bin is enough",
                String.format(
                        Locale.ROOT,
                        "wavelengths: %d or more around each order's middle, %.2f deviations of its power and at most %s"
                                + " apart; %d or more within the specular order",
                        nodes(),
                        nodeSpacing,
                        Lengths.format(largestStep),
                        band.fewestNodes()));
    }

    @Override
    public int marginX(CoherenceWindow window, double width) {
        return NEAREST_BIN.marginX();
    }

    @Override
    public int marginY(CoherenceWindow window, double height) {
        return NEAREST_BIN.marginY();
    }

    @Override
    public long reads(Plan plan) {
        // A ray from the middle passes at most half of the orders each way.
        long passed = ((long) plan.bandX().count() + plan.bandY().count()) / 2;
        return passed * nodes() * plan.expansion().terms();
    }

    @Override
    public long loopSteps(Plan plan) {
        long passed = ((long) plan.bandX().count() + plan.bandY().count()) / 2;
        return passed * nodes();
    }

    @Override
    public List<ArrayLayout> layouts(Plan plan, MethodUse use) {
        List<ArrayLayout> layouts = BinArrays.layouts(plan);
        layouts.add(ColorArrays.cieWeightsLayout());
        return layouts;
    }

    @Override
    public ShaderTables tables(Plan plan, FourierTable table, MethodUse use, CieTable cie) {
        ShaderTables.Builder tables = BinArrays.tables("full_orders", plan, table, NEAREST_BIN);
        band.addTo(tables);
        return tables.array(ColorArrays.cieWeights(cie))
                .reals("orderReach", reach)
                .reals("orderNodeSpacing", nodeSpacing)
                .reals("orderPanel", panel)
                .reals("orderLargestStep", largestStep)
                .reals("orderCornerLength", cornerLength)
                .reals("windowSigmaFrequency", plan.window().sigmaFrequency())
                .reals("cieWhite", ColorArrays.cieWhite(cie))
                .build(plan.window().sigmaMetres(), plan.specularReach());
    }
}
