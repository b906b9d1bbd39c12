package sunbeam.precompute.plan;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Everything that method {@code full} needs to know beside the patch.
 *
 * @param accuracy what each part was chosen for
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
        Accuracy accuracy,
        VisibleRange range,
        Expansion expansion,
        Band bandX,
        Band bandY,
        CoherenceWindow window,
        WindowOrigin origin,
        Average average,
        Sampling sampling) {

    /** |(u, v)| up to which a direction sees the specular peak, which outshines what is diffracted. */
    public double specularReach() {
        return window.specularReach(CieTable.MAXIMUM_WAVELENGTH);
    }

    /**
     * All of it that decides what a shader reads, as text: equal texts of one patch mean equal tables. Numbers are written so
     * that no two of them are written alike.
     */
    public String key() {
        return String.join(
                "|",
                expansion.key(),
                bandX.toString(),
                bandY.toString(),
                range.toString(),
                window.toString(),
                origin.toString(),
                average.toString(),
                sampling.toString());
    }
}
