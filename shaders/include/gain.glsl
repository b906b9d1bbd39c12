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

// Mean over relief finer than a pixel, whose slopes s are normally distributed, of relativeRadiance times a color: gain times the color's
// mean over slopes at uvw.
struct ReliefMean {
    vec3 uvw;
    float gain;
};

// Largest shift of the mean slope, in standard deviations. Only at grazing angles it would be larger, where the expansion fails.
const float LARGEST_SHIFT = 1.0;

// To second order in slopes of a variance along either axis. A normal distribution of slopes times exp(a . s), where a is the gradient of ln
// relativeRadiance, is one with the mean slope variance a. A slope turns a direction x, so that x.z becomes (x.z + s . x.xy) / sqrt(1 + s . s),
// whose logarithm has the gradient x.xy / x.z and the Laplacian -(x.xy / x.z)^2 - 2.
ReliefMean reliefMean(vec3 wi, vec3 wr, float variance) {
    vec3 sum = wi + wr;
    vec3 lower = wi.z < wr.z ? wi : wr;
    float masked = 4.0 * sum.z * lower.z < dot(sum, sum) ? 1.0 : 0.0;
    vec2 ofSum = sum.xy / sum.z;
    vec2 ofView = wr.xy / wr.z;
    vec2 ofLower = lower.xy / lower.z;
    vec2 gradient = (masked - 2.0) * ofSum - ofView + masked * ofLower;
    float laplacian = (2.0 - masked) * dot(ofSum, ofSum) + dot(ofView, ofView) - masked * dot(ofLower, ofLower)
            + 6.0 - 4.0 * masked;
    float square = variance * dot(gradient, gradient);
    float limit = min(1.0, LARGEST_SHIFT * inversesqrt(max(square, 1e-12)));
    vec2 slope = limit * variance * gradient;
    float growth = 0.5 * limit * limit * clamp(square + variance * laplacian, -1.0, 1.0);
    vec3 uvw = diffractionVector(wi, wr);
    vec3 turned = vec3(uvw.xy - slope * uvw.z, uvw.z + dot(slope, uvw.xy));
    return ReliefMean(turned, relativeRadiance(wi, wr) * exp(growth));
}
