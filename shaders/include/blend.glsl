#include "include/srgb.glsl"

// Diffracted light and body color on one skin (thesis algorithm 3.4), in linear XYZ with white at Y = 1.

// Factor of the diffracted light, factor of the texture, shares of Lambert and ambient light.
uniform float diffractionWeight;
uniform float textureWeight;
uniform float diffuseWeight;
uniform float ambientWeight;
// Opacity over the body: 0 for that of the diffracted light, 1 for Fresnel's reflectance, as in the thesis.
uniform float fresnelAlpha;

// ambient: share of the ambient light that reaches the point, 0 to 1.
// The luminance of the diffracted light, relative to white, is its opacity over the body. In the thesis the opacity is the reflectance and
// hides Lambert's part alone; ambient light is mixed with the rest, in gamma-encoded RGB. Here light is added in linear XYZ.
vec3 blended(vec3 diffractedXyz, vec3 albedoXyz, float cosTheta_i, float reflectance, float ambient) {
    vec3 diffracted = diffractionWeight * diffractedXyz;
    vec3 body = textureWeight * albedoXyz;
    float alpha = mix(min(diffracted.y, 1.0), reflectance, fresnelAlpha);
    vec3 lit = diffracted + (1.0 - alpha) * diffuseWeight * max(cosTheta_i, 0.0) * body;
    float ambientShare = mix(1.0 - alpha, 1.0, fresnelAlpha);
    return (1.0 - fresnelAlpha * ambientWeight) * lit + ambientShare * ambientWeight * ambient * body;
}
