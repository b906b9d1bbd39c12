// The averages of power over the places of the coherence window: what each method says of one wavelength, and which of them
// (AVERAGE) its colours are made of. A method defines those that it has.

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
