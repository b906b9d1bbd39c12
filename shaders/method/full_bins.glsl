#include "include/wavelengths.glsl"
#include "method/neighborhood.glsl"

// The thesis's FLSS (algorithm 3.3): sum over fixed wavelengths; at each, expansion terms times a Gaussian neighborhood of DFT bins.

vec3 diffractedXyz(vec3 uvw) {
    return fixedWavelengthsXyz(uvw);
}
