package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;

/** How many wavelengths the panels of Gauss's rule take over the visible band, as shaders/include/integral.glsl places them. */
final class GaussPanels {
    private static final int NODES = 4;
    private static final int GRADED = 4;

    private GaussPanels() {}

    /** The largest panel in 1 / lambda, 1 / metres, that leaves so many wavelengths or more. */
    static double largest(int nodes) {
        return band() / Math.ceil((double) nodes / NODES);
    }

    /** Wavelengths where the ray is so short that the largest panel decides. */
    static int fewestNodes(double largest) {
        return nodes((int) Math.round(band() / largest));
    }

    /**
     * Wavelengths of a ray.
     *
     * @param largest panel in 1 / lambda, 1 / metres
     * @param panel along the ray, cycles per metre
     * @param uv length of (u, v)
     */
    static int nodes(double largest, double panel, double uv) {
        return Math.max(fewestNodes(largest), nodes((int) Math.ceil(uv * band() / panel)));
    }

    private static int nodes(int panels) {
        return NODES * (Math.max(2, panels) + GRADED);
    }

    private static double band() {
        return 1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH;
    }
}
