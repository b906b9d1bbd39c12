package sunbeam.precompute.plan;

import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Everything that method {@code full} needs to know beside the patch.
 *
 * @param expansion of exp(i k w h), with its number of terms
 * @param bandX bins along x that are computed and stored
 * @param bandY bins along y that are computed and stored
 * @param window the coherence window
 * @param origin the sample under its maximum
 * @param neighbourhood the bins that are summed
 * @param average which power
 * @param wavelengths nodes and weights
 */
public record Plan(
        Expansion expansion,
        Band bandX,
        Band bandY,
        CoherenceWindow window,
        WindowOrigin origin,
        Neighbourhood neighbourhood,
        Average average,
        WavelengthNodes wavelengths) {}
