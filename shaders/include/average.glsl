// The averages of power over the places of the coherence window: what each method says of one wavelength, and which of them
// (AVERAGE) its colors are made of. A method defines those that it has.

#ifdef SPECTRAL
// The direction's frequency in DFT bins of the patch, from double precision: the nearest bin, and how far beyond it the
// frequency lies. Far orders of a wide window are narrower than float32 tells frequencies apart.
vec4 exactBin;
#endif

// One coherence area: amplitudes add up and are squared last (thesis algorithm 3.3).
float coherentPower(vec3 uvw, float wavelength);

// Mean over all positions of the window, Stam's angle brackets: squares add up (thesis eq. 2.29 in spirit).
float ensemblePower(vec3 uvw, float wavelength);

const bool ENSEMBLE = AVERAGE == AVERAGE_ENSEMBLE;

// The one that was chosen. A condition of the language would ask for both functions, and a method may lack one.
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
