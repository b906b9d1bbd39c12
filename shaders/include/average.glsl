// Averages of power at one wavelength over positions of the coherence window. A method defines those that it has; AVERAGE selects the one
// for its colors.

#ifdef SPECTRAL
// The direction's frequency in DFT bins of the patch, rounded from double precision: nearest bin (xy) and distance to it (zw). High orders
// of a wide window are narrower than float32 resolves frequencies.
vec4 exactBin;
#endif

// One coherence area: amplitudes add up and are squared last (thesis algorithm 3.3).
float coherentPower(vec3 uvw, float wavelength);

// Mean over all positions of the window, Stam's angle brackets: squares add up (thesis eq. 2.29 in spirit).
float ensemblePower(vec3 uvw, float wavelength);

const bool ENSEMBLE = AVERAGE == AVERAGE_ENSEMBLE;

// The selected average. Preprocessor conditions, since a method may lack one of the functions.
float averagePower(vec3 uvw, float wavelength) {
#if AVERAGE == AVERAGE_ENSEMBLE
    return ensemblePower(uvw, wavelength);
#else
    return coherentPower(uvw, wavelength);
#endif
}

// Power of a complex amplitude (real, imaginary).
float squaredMagnitude(vec2 amplitude) {
    return dot(amplitude, amplitude);
}
