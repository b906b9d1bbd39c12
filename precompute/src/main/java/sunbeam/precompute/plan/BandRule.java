package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Where wavelengths lie on rays whose power the visible band cuts (shaders/include/integral.glsl): in equal steps of 1 / lambda
 * with Gregory's corrections where the ray f = (u, v) / lambda is short, since equal steps bear the kinks of D65's table best;
 * on panels of Gauss's rule where it crosses orders that are narrow beside these.
 *
 * @param fewestNodes equal steps
 * @param reach |(u, v)| up to which they resolve the orders
 * @param panel size of a panel along the ray, cycles per metre
 * @param largestPanel in 1 / lambda, 1 / metres
 */
public record BandRule(int fewestNodes, double reach, double panel, double largestPanel) {
    private static final int NODES_PER_PANEL = 4;
    // Panels at both ends are divided.
    private static final int GRADED_PANELS = 4;
    // Kinks of D65's table, 5 nm apart, lie anywhere in a panel: with two nodes where equal steps have one, both err
    // alike.
    private static final double NODES_BESIDE_EQUAL = 2;
    // A flank beside the band falls faster than an order one deviation from its middle.
    private static final double STEEPEST_FLANK = 2;
    private static final double BAND = 1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH;

    /**
     * @param deviation of an order's power along the ray, cycles per metre
     * @param spacing of equal steps that resolve it, in these
     * @param panel of Gauss's rule, in these
     */
    static BandRule of(int fewestNodes, double deviation, double spacing, double panel) {
        return new BandRule(
                fewestNodes,
                fewestNodes * spacing * deviation / BAND / STEEPEST_FLANK,
                panel * deviation,
                BAND * NODES_PER_PANEL / (NODES_BESIDE_EQUAL * fewestNodes));
    }

    /**
     * For a patch whose light goes everywhere: equal steps that resolve orders serve as far as they do, since no lone flank
     * is seen at the band's ends.
     *
     * @param step of equal steps that resolve an order, cycles per metre
     */
    BandRule evenlyTo(double step) {
        return new BandRule(fewestNodes, fewestNodes * step / BAND, panel, largestPanel);
    }

    /** Wavelengths of a ray of this |(u, v)|. */
    int nodes(double uv) {
        if (uv <= reach) {
            return fewestNodes;
        }
        double equal = Math.max(2, Math.ceil(BAND / Math.min(largestPanel, panel / uv) - 1e-3));
        return NODES_PER_PANEL * ((int) equal + GRADED_PANELS);
    }

    /** Most wavelengths of any ray up to this |(u, v)|. */
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
