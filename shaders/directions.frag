#version 330 core
#include "include/gain.glsl"
#include "method/{METHOD}.glsl"
#include "include/loops.glsl"

// Evaluates a list of pairs of directions, one per fragment, by the same functions as maps.

// Four texels per fragment, one below the other: (wi, 0), (wr, 0), (u, v, w, wavelength in meters), exactBin (include/average.glsl). The
// last two are computed in double precision, because wi and wr cancel in u and v near the specular direction.
uniform sampler2D directions;
// With SPECTRAL: coherent power, ensemble power (with ONE_POWER the method's average in both). Without: X, Y, Z of power, and the relative
// radiance per power.
layout(location = 0) out vec4 result;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) * ivec2(1, 4);
    vec3 wi = texelFetch(directions, texel, 0).xyz;
    vec3 wr = texelFetch(directions, texel + ivec2(0, 1), 0).xyz;
    vec4 uvwLambda = texelFetch(directions, texel + ivec2(0, 2), 0);
#ifdef SPECTRAL
    exactBin = texelFetch(directions, texel + ivec2(0, 3), 0);
#ifdef ONE_POWER
    // The other average is not needed and may take hundreds of times as long.
    float power = ENSEMBLE ? ensemblePower(uvwLambda.xyz, uvwLambda.w) : coherentPower(uvwLambda.xyz, uvwLambda.w);
    result = vec4(power, power, 0.0, 0.0);
#else
    result = vec4(
        coherentPower(uvwLambda.xyz, uvwLambda.w), ensemblePower(uvwLambda.xyz, uvwLambda.w), 0.0, 0.0);
#endif
#else
    result = vec4(diffractedXyz(uvwLambda.xyz), relativeRadiance(wi, wr));
#endif
    if (loopsWereCut()) {
        result = vec4(LOOPS_CUT);
    }
}
