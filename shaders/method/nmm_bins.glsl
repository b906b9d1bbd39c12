// The bins around a frequency, of both forms of nmm.

#ifdef SPECTRAL
// Asked for one wavelength, the sum over orders has a power of its own.
#define coherentPower coherentBinsPower
#define ensemblePower ensembleBinsPower
#endif
#include "method/neighborhood.glsl"
#ifdef SPECTRAL
#undef coherentPower
#undef ensemblePower

// Coherent power of the bins around a frequency at another wavelength than the one that is asked for.
float coherentBinsPowerAt(vec3 uvw, float wavelength) {
    vec2 position = uvw.xy / wavelength * tablePeriod;
    vec2 nearest = floor(position + 0.5);
    exactBin = vec4(nearest, position - nearest);
    binsAreSummed = false;
    return coherentBinsPower(uvw, wavelength);
}
#endif
