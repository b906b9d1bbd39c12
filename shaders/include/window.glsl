// The Gaussian coherence window, seen from frequency space.

// Standard deviation of its spectrum in DFT bins of the patch, along x and y.
uniform vec2 windowSigmaBins;

// Weight of the amplitude of a bin at a distance from the frequency, in bins.
float windowAmplitude(float distance, float sigma) {
    float ratio = distance / sigma;
    return exp(-0.5 * ratio * ratio);
}
