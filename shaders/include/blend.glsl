#include "include/srgb.glsl"

// Diffracted light and body color on one skin (thesis algorithm 3.4), in linear XYZ with white at Y = 1.

// Factor of the diffracted light, factor of the texture, shares of Lambert and ambient light.
uniform float diffractionWeight;
uniform float textureWeight;
uniform float diffuseWeight;
uniform float ambientWeight;

// The body alone: its texture under a Lambert and an ambient part of the light.
vec3 bodyXyz(vec3 albedoXyz, float cosTheta_i) {
    return textureWeight * (ambientWeight + diffuseWeight * max(cosTheta_i, 0.0)) * albedoXyz;
}

// The brighter the diffracted light in proportion to white, the less of the body is seen through it: alpha of the
// algorithm. The thesis weights gamma-encoded RGB; here light adds up as light.
vec3 blended(vec3 diffractedXyz, vec3 albedoXyz, float cosTheta_i) {
    vec3 diffracted = diffractionWeight * diffractedXyz;
    float alpha = min(diffracted.y, 1.0);
    return diffracted + (1.0 - alpha) * bodyXyz(albedoXyz, cosTheta_i);
}
