package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Quadrature rule over the wavelengths of a ray f = (u, v) / lambda, for orders that the ends of the visible band cut
 * (shaders/include/integral.glsl). Short rays get equal steps of 1 / lambda with Gregory's end corrections, which suit the kinks of D65's
 * table best. Longer rays, which cross orders narrower than these steps, get panels of Gauss's rule.
 *
 * @param fewestNodes number of wavelengths with equal steps
 * @param reach |(u, v)| up to which equal steps resolve the orders
 * @param panel size of a panel along the ray, cycles per meter
 * @param largestPanel largest size of a panel in 1 / lambda, 1 / meters
 */
public record BandRule(int fewestNodes, double reach, double panel, double largestPanel) {
    private static final int NODES_PER_PANEL = 4;
    // Panels of one step at both ends, subdivided.
    private static final int GRADED_PANELS = 4;
    // Nodes of Gauss's rule per equal step: with one, the kinks of D65's table, which lie anywhere in a panel, cost
    // more.
    private static final double GAUSS_NODES_PER_STEP = 2;
    // Where the band cuts off an order's middle, only its flank is left, which falls this much faster.
    private static final double STEEPEST_FLANK = 2;

    /**
     * @param deviation standard deviation of an order's power along the ray, cycles per meter
     * @param spacing equal step that resolves an order, in deviations
     * @param panel size of a panel of Gauss's rule, in deviations
     */
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

    /** Wavelengths of a ray of this |(u, v)|. */
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
