// Averages of power at one wavelength over positions of the coherence window. A method defines one or both of the functions below; AVERAGE
// selects the one for its colors.

#ifdef SPECTRAL
// Frequency (u, v) / wavelength in DFT bins of the patch, from double precision: the nearest bin (xy) and the distance from that bin (zw).
// High orders of a wide window are narrower than the steps of float32 frequencies.
vec4 exactBin;
#endif

// Power of one coherence area: amplitudes add up and are squared last (thesis algorithm 3.3).
float coherentPower(vec3 uvw, float wavelength);

// Mean power over all positions of the window, Stam's angle brackets: squares add up (in the spirit of thesis eq. 2.57).
float ensemblePower(vec3 uvw, float wavelength);

const bool ENSEMBLE = AVERAGE == AVERAGE_ENSEMBLE;

// Power of the selected average. Selected by the preprocessor, since a method may lack one of the functions.
float averagePower(vec3 uvw, float wavelength) {
#if AVERAGE == AVERAGE_ENSEMBLE
    return ensemblePower(uvw, wavelength);
#else
    return coherentPower(uvw, wavelength);
#endif
}

float squaredMagnitude(vec2 amplitude) {
    return dot(amplitude, amplitude);
}
