// Diffracted light and body colour on one skin (thesis algorithm 3.4), in linear XYZ with white at Y = 1.

// Factor of the diffracted light, factor of the texture, shares of Lambert and ambient light.
uniform float diffractionWeight;
uniform float textureWeight;
uniform float diffuseWeight;
uniform float ambientWeight;

// Linear sRGB to XYZ (IEC 61966-2-1); inverse of the matrix in display.glsl, columns of red, green, blue.
vec3 linearSrgbToXyz(vec3 rgb) {
    const mat3 TO_XYZ = mat3(
            0.4124564, 0.2126729, 0.0193339,
            0.3575761, 0.7151522, 0.1191920,
            0.1804375, 0.0721750, 0.9503041);
    return TO_XYZ * rgb;
}

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
