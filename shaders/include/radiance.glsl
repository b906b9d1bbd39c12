#include "include/gain.glsl"

#include "method/{METHOD}.glsl"
#include "include/loops.glsl"

// What the chosen method diffracts from a light into a direction: linear XYZ of the relative radiance. Both directions in
// the tangent frame, above the surface.
vec3 diffractedRadiance(vec3 wi, vec3 wr) {
    vec3 xyz = relativeRadiance(wi, wr) * diffractedXyz(diffractionVector(wi, wr));
    return loopsWereCut() ? vec3(LOOPS_CUT) : xyz;
}
