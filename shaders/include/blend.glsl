#include "include/srgb.glsl"

// Diffracted light and body color on one skin (thesis algorithm 3.4), in linear XYZ with white at Y = 1.

// Factor of the diffracted light, factor of the texture, shares of Lambert and ambient light.
uniform float diffractionWeight;
uniform float textureWeight;
uniform float diffuseWeight;
uniform float ambientWeight;
// What hides the body: 0 for the diffracted light, 1 for Fresnel's reflectance, as in the thesis.
uniform float fresnelAlpha;

// everywhere: the share of ambient light that arrives.
// The brighter the diffracted light in proportion to white, the less of the body is seen through it. In the thesis, alpha is the
// reflectance, hides Lambert's part alone, and ambient light takes its share of all else. It adds gamma-encoded RGB; here light
// adds up as light.
vec3 blended(vec3 diffractedXyz, vec3 albedoXyz, float cosTheta_i, float reflectance, float everywhere) {
    vec3 diffracted = diffractionWeight * diffractedXyz;
    vec3 body = textureWeight * albedoXyz;
    float alpha = mix(min(diffracted.y, 1.0), reflectance, fresnelAlpha);
    vec3 lit = diffracted + (1.0 - alpha) * diffuseWeight * max(cosTheta_i, 0.0) * body;
    float ambientShare = mix(1.0 - alpha, 1.0, fresnelAlpha);
    return (1.0 - fresnelAlpha * ambientWeight) * lit + ambientShare * ambientWeight * everywhere * body;
}
