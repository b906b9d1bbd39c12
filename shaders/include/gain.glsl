#include "include/constants.glsl"
#include "include/fresnel.glsl"
#include "include/frame.glsl"
#include "include/mask.glsl"

// Factors from diffracted power to radiance (Stam 1999 eq. 12).

#ifdef ENERGY_CONSERVED
// Share of the light that is left to all directions so that no more leaves than arrives, over x and y of the direction of light, -1 to 1
// (sunbeam.precompute.analysis.EnergyDivisor).
uniform sampler2D energyShares;
#endif

// Relative radiance per power, 1 for a flat mirror seen along the normal: F (S / 2)^2 / ((wi.z + wr.z)^2 wr.z) times the mask, with the
// relative reflectance F. S = |wi + wr|^2: the Kirchhoff factor 1 + wi . wr is S / 2, and the cosine between half vector and directions is
// sqrt(S) / 2.
float relativeRadiance(vec3 wi, vec3 wr) {
    vec3 sum = wi + wr;
    float square = dot(sum, sum);
    float reflectance = relativeReflectance(0.5 * sqrt(square));
    float radiance = reflectance * square * maskedSquare(square, sum.z, min(wi.z, wr.z)) / (4.0 * sum.z * sum.z * wr.z);
#ifdef ENERGY_CONSERVED
    radiance *= textureLod(energyShares, 0.5 + 0.5 * wi.xy, 0.0).r;
#endif
    return radiance;
}
