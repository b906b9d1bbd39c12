package sunbeam.precompute.radial;

import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.resample.PowerFields;
import sunbeam.precompute.table.FourierTable;

/**
 * Power spectrum of a surface: |F_j|^2 of its DFT bins as a short sum of functions of the phase k |w| h. From it colors of the ensemble average
 * follow under any window that is no longer than the one that it was made for: it is built once a surface, and each baker windows it. Immutable,
 * safe for use by several threads.
 */
public final class PowerSpectrum {
    /** Deviations of the widest window whose bins are kept beyond what is visible. */
    private static final double MARGIN = 4;

    /** In sigma_f: Gaussians around places so far apart give those between by polynomials of degree 7 to 1e-3. */
    private static final double DECIMATED_SPACING = 0.4;

    /**
     * From place to place on a ray, in ln |(u, v)|, at a tolerance of 1 %. Beside an order's ends, where the visible band is cut off, splines
     * err most: sharp orders show it, as those of a small scan under a long window.
     */
    private static final double WIDEST_PLACES = 0.0082;

    /** Power of the tolerance with which places move closer. */
    private static final double PLACES_POWER = 0.1;

    private final PhaseSamples coefficients;
    private final HeightScale scale;
    private final SpectrumPlane bins;
    // Rows as columns; once for all levels whose bins are not decimated.
    private final SpectrumPlane turned;
    private final double widestPlaces;

    /**
     * Squares the terms of a table.
     *
     * @param plan that the table was made for
     * @param tolerance relative error of colors
     */
    public PowerSpectrum(Plan plan, FourierTable table, double tolerance) {
        PowerFields fields = new PowerFields(table, plan.expansion(), new ErrorBudget(tolerance).powerBasis());
        this.scale = table.scale();
        this.coefficients = PhaseSamples.of(
                fields::functions,
                plan.expansion().minimumPhase(),
                plan.expansion().maximumPhase());
        this.widestPlaces = WIDEST_PLACES * Math.pow(tolerance / 0.01, PLACES_POWER);
        this.bins = SpectrumPlane.of(table, fields);
        this.turned = bins.transposed();
    }

    /**
     * A plan with the bins that windows see which are shorter, down to one.
     *
     * @param width of the surface, metres
     * @param height of the surface, metres
     * @param shortest of the windows
     */
    public static Plan widened(Plan plan, double width, double height, CoherenceWindow shortest) {
        double margin = MARGIN * shortest.sigmaFrequency();
        return new Plan(
                plan.tolerance(),
                plan.range(),
                plan.expansion(),
                widened(plan.bandX(), (int) Math.ceil(margin * width)),
                widened(plan.bandY(), (int) Math.ceil(margin * height)),
                plan.window(),
                plan.origin(),
                plan.average(),
                plan.sampling());
    }

    private static Band widened(Band band, int bins) {
        return Band.of(band.first() - bins, band.last() + bins);
    }

    /**
     * The spectrum under a window.
     *
     * @param reach in the window's sigma_f, beyond which a bin is left out
     * @param decimated whether bins that lie close beside the window's width may be taken together, which errs by a thousandth
     */
    WindowedSpectrum under(CoherenceWindow window, double reach, boolean decimated) {
        double spacing = DECIMATED_SPACING * window.sigmaFrequency();
        int factorX = decimated ? (int) Math.max(1, spacing * bins.periodX()) : 1;
        int factorY = decimated ? (int) Math.max(1, spacing * bins.periodY()) : 1;
        if (factorX == 1 && factorY == 1) {
            return new WindowedSpectrum(this, bins, turned, window, reach);
        }
        SpectrumPlane fewer = bins.decimated(factorX, factorY);
        return new WindowedSpectrum(this, fewer, fewer.transposed(), window, reach);
    }

    /** The spectrum under shorter windows; parameters as of {@link GaussianPyramid}. */
    GaussianPyramid pyramid(double ofPoints, double narrowest, double widest, double farthest) {
        return new GaussianPyramid(bins, ofPoints, narrowest, widest, farthest);
    }

    /**
     * How far from each other, in ln |(u, v)|, places on a ray may lie in smooth light: colors change along a ray only as fast as
     * color matching functions do with the wavelength, however sharp orders are.
     */
    double widestPlaces() {
        return widestPlaces;
    }

    /**
     * Coefficients of the terms; beyond the phases that they were made for, at the last of them.
     *
     * @param wavelength metres
     * @param depth |w|
     */
    double[] coefficients(double wavelength, double depth) {
        return coefficients.at(scale.phase(wavelength, depth));
    }
}
