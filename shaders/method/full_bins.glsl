#include "include/wavelengths.glsl"
#include "method/neighbourhood.glsl"

// Fixed wavelengths, expansion terms times a Gaussian neighbourhood of DFT bins: the thesis's FLSS (algorithm 3.3).

vec3 diffractedXyz(vec3 uvw) {
    return fixedWavelengthsXyz(uvw);
}
