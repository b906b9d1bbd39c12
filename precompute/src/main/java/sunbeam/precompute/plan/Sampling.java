package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.resample.InterpolationDesign;

/** How the windowed spectrum is read off the DFT bins, and at which wavelengths. */
public sealed interface Sampling {

    /** Sums a neighbourhood of bins at fixed wavelengths: the thesis's way. */
    record Bins(Neighbourhood neighbourhood, WavelengthNodes wavelengths) implements Sampling {}

    /**
     * Looks at the nearest bin only, at wavelengths placed around the middle of each order that a direction sees: for
     * patches so small that the window resolves every order.
     *
     * @param reach how far from an order's middle wavelengths lie, in standard deviations of the order's power
     * @param nodeSpacing their distance, likewise
     * @param cutSpacing the same for orders that the visible band cuts
     * @param largestStep their largest distance in metres: orders near the specular one are broader than the structure of
     *     the colour matching functions and D65
     * @param specularNodes wavelengths within the specular order, which has no middle
     */
    record Orders(double reach, double nodeSpacing, double cutSpacing, double largestStep, int specularNodes)
            implements Sampling {}

    /**
     * Sums a neighbourhood of bins, at wavelengths in equal steps along the ray f = (u, v) / lambda: for orders that the
     * window neither resolves nor blurs, and for windows so large that a grid would not fit into memory.
     *
     * @param neighbourhood the bins
     * @param nodeStep distance of the wavelengths along the ray, cycles per metre
     * @param fewestNodes wavelengths of directions whose ray is shorter than so many steps
     */
    record Rays(Neighbourhood neighbourhood, double nodeStep, int fewestNodes) implements Sampling {}

    /**
     * Interpolates spectra that were windowed and resampled beforehand. Wavelengths lie where the ray f = (u, v) / lambda
     * crosses the columns of a grid, so that only one axis is left to interpolate.
     *
     * @param interpolation along that axis
     * @param nodeStep distance of the columns, cycles per metre
     * @param largestStride a ray that crosses many columns stops at every second one, or third, up to this
     * @param fewestNodes directions whose ray crosses fewer columns than this within the visible band, those near the
     *     specular one, take this many equal steps of 1 / lambda and interpolate both axes
     */
    record Grid(InterpolationDesign interpolation, double nodeStep, int largestStride, int fewestNodes)
            implements Sampling {

        /** The same with another interpolation. */
        public Grid with(InterpolationDesign other) {
            return new Grid(other, nodeStep, largestStride, fewestNodes);
        }

        /** Largest of |u|, |v| up to which both axes are interpolated. */
        public double centreReach() {
            double waveNumbers = 1 / CieTable.MINIMUM_WAVELENGTH - 1 / CieTable.MAXIMUM_WAVELENGTH;
            return fewestNodes * nodeStep / waveNumbers;
        }
    }
}
