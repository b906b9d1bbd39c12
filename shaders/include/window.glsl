// The Gaussian coherence window in frequency space.

// Standard deviation of the window's spectrum in DFT bins of the patch, along x and y.
uniform vec2 windowSigmaBins;

// Weight of a bin's amplitude; distance: from the bin to the frequency, and sigma: standard deviation, both in bins along one axis.
float windowAmplitude(float distance, float sigma) {
    float ratio = distance / sigma;
    return exp(-0.5 * ratio * ratio);
}

// Weight of a bin's power at an offset from it; sigma, of the amplitude's spectrum, is in the offset's unit.
float windowPower(vec2 offset, float sigma) {
    return exp(-dot(offset, offset) / (sigma * sigma));
}
