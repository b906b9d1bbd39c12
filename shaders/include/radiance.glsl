#include "include/gain.glsl"

#include "method/{METHOD}.glsl"
#include "include/loops.glsl"

// Relative radiance, linear XYZ, of light diffracted from wi into wr by the method. Both directions are in the tangent frame, above the
// surface.
vec3 diffractedRadiance(vec3 wi, vec3 wr) {
    vec3 xyz = relativeRadiance(wi, wr) * diffractedXyz(diffractionVector(wi, wr));
    return loopsWereCut() ? vec3(LOOPS_CUT) : xyz;
}
