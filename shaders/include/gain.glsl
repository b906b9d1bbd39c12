#include "include/constants.glsl"
#include "include/fresnel.glsl"
#include "include/frame.glsl"
#include "include/mask.glsl"

// Factors from diffracted power to radiance (design section 3; Stam 1999 eq. 12).

// Relative radiance per power; 1 for the flat mirror seen along the normal.
float relativeRadiance(vec3 wi, vec3 wr) {
    float kirchhoff = kirchhoffFactor(wi, wr);
    float sum = wi.z + wr.z;
    float cosThetaD = halfAngleCosine(wi, wr);
    return relativeReflectance(cosThetaD) * kirchhoff * kirchhoff / (sum * sum * wr.z) * cavityMask(wi, wr, cosThetaD);
}

// BRDF in 1/sr per power, without the mask. The window's effective area is pi sigma^2.
float brdfPerPower(vec3 wi, vec3 wr, float wavelength, float windowSigma) {
    float kirchhoff = kirchhoffFactor(wi, wr);
    // One ratio of lengths near 100 instead of squares of lengths near 1e-13.
    float ratio = kirchhoff * windowSigma / (wavelength * (wi.z + wr.z));
    return NORMAL_REFLECTANCE * relativeReflectance(halfAngleCosine(wi, wr)) * 4.0 * PI * ratio * ratio / (wi.z * wr.z);
}
