package sunbeam.precompute.rays;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.resample.PowerFields;
import sunbeam.precompute.table.FourierTable;

/**
 * The powers of a surface's DFT bins in terms of the phase, from which colors of the ensemble average follow under any window
 * that is no longer than the one that it was made for. Immutable, safe for use by several threads.
 */
public final class RaySpectrum {
    // Deviations of the widest window whose bins are kept beyond what is visible.
    private static final double MARGIN = 4;

    // In sigma_f of a window: Gaussians around places so far apart give those between by polynomials of degree 7 to
    // 1e-3.
    private static final double FOLDED_SPACING = 0.4;

    // In ln |(u, v)|: from place to place on a ray at a tolerance of 1 %, and less with this power of it. Beside an
    // order's ends, where
    // the visible band is cut off, splines err most: sharp orders show it, as those of a small scan under a long
    // window.
    private static final double WIDEST_PLACES = 0.0082;
    private static final double PLACES_POWER = 0.1;

    private final PhaseSamples coefficients;
    private final HeightScale scale;
    private final BinPlane bins;
    // Rows as columns; once for all levels that take no bins together.
    private final BinPlane turned;
    private final CieTable cie;
    private final double shortestWavelength;
    private final double longestWavelength;
    private final double widestPlaces;

    /**
     * Takes the terms of a table.
     *
     * @param plan that the table was made for
     * @param tolerance relative error of colors
     */
    public RaySpectrum(Plan plan, FourierTable table, double tolerance, CieTable cie) {
        PowerFields fields = new PowerFields(table, plan.expansion(), new ErrorBudget(tolerance).powerBasis());
        this.scale = table.scale();
        this.coefficients = PhaseSamples.of(
                fields::functions,
                plan.expansion().minimumPhase(),
                plan.expansion().maximumPhase());
        this.cie = cie;
        this.shortestWavelength = cie.shortestWavelength();
        this.longestWavelength = cie.longestWavelength();
        this.widestPlaces = WIDEST_PLACES * Math.pow(tolerance / 0.01, PLACES_POWER);
        double[][] terms = new double[fields.count()][];
        for (int m = 0; m < terms.length; m++) {
            terms[m] = fields.field(m);
        }
        this.bins = BinPlane.of(
                table.patch().columns() * table.patch().pitchX(),
                table.patch().rows() * table.patch().pitchY(),
                table.bandX().first(),
                table.bandY().first(),
                table.bandX().count(),
                table.bandY().count(),
                terms);
        this.turned = bins.transposed();
    }

    private RaySpectrum(RaySpectrum other, CieTable cie) {
        this.coefficients = other.coefficients;
        this.scale = other.scale;
        this.bins = other.bins;
        this.turned = other.turned;
        this.widestPlaces = other.widestPlaces;
        this.cie = cie;
        this.shortestWavelength = cie.shortestWavelength();
        this.longestWavelength = cie.longestWavelength();
    }

    /** The same powers in other light, or seen by others. */
    public RaySpectrum seenBy(CieTable other) {
        return new RaySpectrum(this, other);
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
     * The powers under a window.
     *
     * @param reach in the window's sigma_f, beyond which a bin is left out
     * @param folded whether bins that lie close beside the window's width may be taken together, which errs by a thousandth
     */
    WindowedPowers under(GaussianArea area, double reach, boolean folded) {
        double spacing = FOLDED_SPACING * area.window().sigmaFrequency();
        int foldX = folded ? (int) Math.max(1, spacing * bins.periodX()) : 1;
        int foldY = folded ? (int) Math.max(1, spacing * bins.periodY()) : 1;
        if (foldX == 1 && foldY == 1) {
            return new WindowedPowers(bins, turned, area.window(), reach);
        }
        BinPlane fewer = bins.folded(foldX, foldY);
        return new WindowedPowers(fewer, fewer.transposed(), area.window(), reach);
    }

    /** The powers under shorter windows; parameters as of {@link PowerLadder}. */
    PowerLadder ladder(double ofPoints, double narrowest, double widest, double farthest) {
        return new PowerLadder(bins, ofPoints, narrowest, widest, farthest);
    }

    /** Wavelengths of the light at equal steps of their logarithm. */
    WavelengthNodes wavelengths(double widestStep) {
        return IntegratedNodes.logarithmic(cie, widestStep).withoutDarkEnds();
    }

    /** The shortest wavelength of the light, metres. */
    double shortestWavelength() {
        return shortestWavelength;
    }

    /** The longest wavelength of the light, metres. */
    double longestWavelength() {
        return longestWavelength;
    }

    /** Whether the light changes with the wavelength as gently as daylight. */
    boolean isSmooth() {
        return cie.isSmooth();
    }

    /**
     * How far from each other, in ln |(u, v)|, places on a ray may lie in smooth light: colors change along a ray only as fast as
     * color matching functions do with the wavelength, however sharp orders are.
     */
    double widestPlaces() {
        return widestPlaces;
    }

    /** Coefficients of the terms; beyond the phases that they were made for, at the last of them. */
    double[] coefficients(double wavelength, double depth) {
        return coefficients.at(scale.phase(wavelength, depth));
    }
}
