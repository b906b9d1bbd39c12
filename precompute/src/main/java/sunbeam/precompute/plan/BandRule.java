package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Quadrature rule for rays whose orders the visible band cuts (shaders/include/integral.glsl). Short rays f = (u, v) / lambda get equal
 * steps of 1 / lambda with Gregory's end corrections, which suit the kinks of D65's table best; longer ones, which cross orders narrower
 * than the steps, get panels of Gauss's rule.
 *
 * @param fewestNodes number of equal steps
 * @param reach |(u, v)| up to which they resolve the orders
 * @param panel size of a panel along the ray, cycles per meter
 * @param largestPanel in 1 / lambda, 1 / meters
 */
public record BandRule(int fewestNodes, double reach, double panel, double largestPanel) {
    private static final int NODES_PER_PANEL = 4;
    // Panels at both ends are subdivided.
    private static final int GRADED_PANELS = 4;
    // Nodes per equal step: kinks of D65's table, 5 nm apart, lie anywhere in a panel; with twice the nodes both rules
    // err alike.
    private static final double NODES_BESIDE_EQUAL = 2;
    // A flank outside the band falls faster than an order does one deviation from its middle.
    private static final double STEEPEST_FLANK = 2;
    private static final double BAND = 1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH;

    /**
     * @param deviation standard deviation of an order's power along the ray, cycles per meter
     * @param spacing of equal steps that resolve it, in deviations
     * @param panel of Gauss's rule, in deviations
     */
    static BandRule of(int fewestNodes, double deviation, double spacing, double panel) {
        return new BandRule(
                fewestNodes,
                fewestNodes * spacing * deviation / BAND / STEEPEST_FLANK,
                panel * deviation,
                BAND * NODES_PER_PANEL / (NODES_BESIDE_EQUAL * fewestNodes));
    }

    /**
     * Returns the rule for a rough patch: equal steps that resolve orders suffice, since no order stands alone at the band's ends.
     *
     * @param step equal step that resolves an order, cycles per meter
     */
    BandRule evenlyTo(double step) {
        return new BandRule(fewestNodes, fewestNodes * step / BAND, panel, largestPanel);
    }

    /** Returns the number of wavelengths of a ray of this |(u, v)|. */
    int nodes(double uv) {
        if (uv <= reach) {
            return fewestNodes;
        }
        double equal = Math.max(2, Math.ceil(BAND / Math.min(largestPanel, panel / uv) - 1e-3));
        return NODES_PER_PANEL * ((int) equal + GRADED_PANELS);
    }

    /** Returns the largest number of wavelengths up to this |(u, v)|. */
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
