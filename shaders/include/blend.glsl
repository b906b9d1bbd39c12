#include "include/srgb.glsl"

// Diffracted light and body color on one skin, in linear XYZ with white at Y = 1.

// Factor of the diffracted light, factor of the texture, shares of Lambert's reflection and of ambient light.
uniform float diffractionWeight;
uniform float textureWeight;
uniform float diffuseWeight;
uniform float ambientWeight;
// Opacity of the diffracted light over the body: 0 for the light's own luminance, 1 for Fresnel's reflectance, as in the thesis.
uniform float fresnelAlpha;
// 1 to add the texture without light, as by algorithm 3.4 of the thesis's text 000; else 0.
uniform float unlitTexture;

// Sum of diffracted light and visible body; ambient: share of the ambient light that reaches the point, 0 to 1. With fresnelAlpha 0
// diffracted light hides the body by its luminance, relative to white. In the thesis (fresnelAlpha 1) the reflectance hides only Lambert's
// part of the body, and ambient light is mixed with the sum, in gamma-encoded RGB. Here light is added in linear XYZ.
vec3 blended(vec3 diffractedXyz, vec3 albedoXyz, float cosTheta_i, float reflectance, float ambient) {
    vec3 diffracted = diffractionWeight * diffractedXyz;
    vec3 body = textureWeight * albedoXyz;
    float alpha = mix(min(diffracted.y, 1.0), reflectance, fresnelAlpha);
    vec3 lit = diffracted + (1.0 - alpha) * diffuseWeight * max(cosTheta_i, 0.0) * body;
    float ambientShare = mix(1.0 - alpha, 1.0, fresnelAlpha);
    vec3 sum = (1.0 - fresnelAlpha * ambientWeight) * lit + ambientShare * ambientWeight * ambient * body;
    return mix(sum, (1.0 - ambientWeight) * diffracted + (1.0 + ambientWeight * ambient) * body, unlitTexture);
}
