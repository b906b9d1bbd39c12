package sunbeam.precompute.plan;

import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Everything that method {@code full} needs to know beside the patch.
 *
 * @param tolerance relative error that each part was chosen for; NaN where a preset chose
 * @param range directions that can occur
 * @param expansion of exp(i k w h), with its number of terms
 * @param bandX bins along x that are computed and stored
 * @param bandY bins along y that are computed and stored
 * @param window the coherence window
 * @param origin the sample under its maximum
 * @param average which power
 * @param sampling how the windowed spectrum is read off the bins, and at which wavelengths
 */
public record Plan(
        double tolerance,
        VisibleRange range,
        Expansion expansion,
        Band bandX,
        Band bandY,
        CoherenceWindow window,
        WindowOrigin origin,
        Average average,
        Sampling sampling) {

    /** The same, sampled otherwise. */
    public Plan with(Sampling other) {
        return new Plan(tolerance, range, expansion, bandX, bandY, window, origin, average, other);
    }
}
