// The powers of the bins around a frequency, for both forms of nmm (nmm and nmm_thesis).

#ifdef SPECTRAL
// Renames neighborhood.glsl's powers, since both forms define coherentPower and ensemblePower themselves.
#define coherentPower coherentBinsPower
#define ensemblePower ensembleBinsPower
#endif
#include "method/neighborhood.glsl"
#ifdef SPECTRAL
#undef coherentPower
#undef ensemblePower

// Coherent power of the bins around a frequency at a given wavelength.
float coherentBinsPowerAt(vec3 uvw, float wavelength) {
    vec2 position = uvw.xy / wavelength * tablePeriod;
    vec2 nearest = floor(position + 0.5);
    exactBin = vec4(nearest, position - nearest);
    binsAreSummed = false;
    return coherentBinsPower(uvw, wavelength);
}
#endif
