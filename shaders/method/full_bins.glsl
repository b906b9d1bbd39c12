#include "include/wavelengths.glsl"
#include "method/neighborhood.glsl"

// Fixed wavelengths, expansion terms times a Gaussian neighborhood of DFT bins: the thesis's FLSS (algorithm 3.3).

vec3 diffractedXyz(vec3 uvw) {
    return fixedWavelengthsXyz(uvw);
}
