package sunbeam.precompute.radial;

import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.PhaseSamples;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.resample.PowerFields;
import sunbeam.precompute.table.FourierTable;

/**
 * Power spectrum of a surface: |F_j|^2 of its DFT bins as a short sum of terms, each a function of the phase zeta times one value per bin.
 * It is built once per surface; each baker applies its own window, which is no longer than that of the plan. Immutable.
 */
public final class PowerSpectrum {
    /** Margin of bins beyond the visible ones, in sigma_f of the shortest window. */
    private static final double MARGIN = 4;

    /** Largest spacing of decimated bins, in sigma_f: polynomials of degree 7 between them err by 1e-3. */
    private static final double DECIMATED_SPACING = 0.4;

    /** Step in ln |(u, v)| at a tolerance of 1 %. Splines err most beside an order that the end of the visible band cuts. */
    private static final double WIDEST_STEP = 0.0082;

    /** Exponent p: the step is proportional to tolerance^p. */
    private static final double STEP_EXPONENT = 0.1;

    private final PhaseSamples coefficients;
    private final HeightScale scale;
    private final SpectrumPlane bins;
    // Transposed bins, shared by all levels without decimation.
    private final SpectrumPlane transposed;
    private final double widestStep;

    public PowerSpectrum(SpectrumPlan plan, FourierTable table, double tolerance) {
        PowerFields fields = new PowerFields(table, plan.expansion(), new ErrorBudget(tolerance).powerBasis());
        this.scale = table.scale();
        this.coefficients = PhaseSamples.of(
                fields::functions,
                plan.expansion().minimumPhase(),
                plan.expansion().maximumPhase());
        this.widestStep = WIDEST_STEP * Math.pow(tolerance / 0.01, STEP_EXPONENT);
        this.bins = SpectrumPlane.of(
                table.patch().width(),
                table.patch().height(),
                table.bandX().first(),
                table.bandY().first(),
                table.bandX().count(),
                table.bandY().count(),
                fields.projections());
        this.transposed = bins.transposed();
    }

    /**
     * Returns a plan that has also the bins within reach of visible directions under shorter windows.
     *
     * @param width of the surface, meters
     * @param height of the surface, meters
     */
    public static SpectrumPlan widened(SpectrumPlan plan, double width, double height, CoherenceWindow shortest) {
        double margin = MARGIN * shortest.sigmaFrequency();
        return new SpectrumPlan(
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
     * @param reach distance in the window's sigma_f beyond which a bin is left out
     * @param decimated whether bins closer than 0.4 sigma_f may be merged, with an error of 1e-3
     */
    WindowedSpectrum withWindow(CoherenceWindow window, double reach, boolean decimated) {
        double spacing = DECIMATED_SPACING * window.sigmaFrequency();
        int factorX = decimated ? (int) Math.max(1, spacing * bins.periodX()) : 1;
        int factorY = decimated ? (int) Math.max(1, spacing * bins.periodY()) : 1;
        if (factorX == 1 && factorY == 1) {
            return new WindowedSpectrum(this, bins, transposed, window, reach);
        }
        SpectrumPlane fewer = bins.decimated(factorX, factorY);
        return new WindowedSpectrum(this, fewer, fewer.transposed(), window, reach);
    }

    GaussianPyramid pyramid(double pointSigmaFrequency, double narrowest, double widest, double farthest) {
        return new GaussianPyramid(bins, pointSigmaFrequency, narrowest, widest, farthest);
    }

    /**
     * Returns the largest step between positions on a ray, in ln |(u, v)|, for light with a smooth spectrum: colors vary along a ray only
     * as fast as the color matching functions do, however sharp orders are.
     */
    double widestStep() {
        return widestStep;
    }

    /** Phases beyond those of the plan are clamped to them. */
    double[] coefficients(double wavelength, double absoluteW) {
        return coefficients.at(scale.phase(wavelength, absoluteW));
    }
}
