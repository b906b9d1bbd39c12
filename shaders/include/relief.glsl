#include "jrtr/tangent_frame.glsl"

// A texel as wide as a sample, between the two levels that are nearest; or of one level, twice as fine, in less time.
vec4 texelAt(sampler2D image, vec2 at) {
#ifdef NEAREST_FINER_LEVEL
    vec2 size = vec2(textureSize(image, 0));
    vec2 a = size * dFdx(at);
    vec2 b = size * dFdy(at);
    // Half of the logarithm of a square, rounded, less one.
    int level = ((floatBitsToInt(max(dot(a, a), dot(b, b))) >> 23) - 127 - 1) >> 1;
    return textureLod(image, at, float(level));
#else
    return texture(image, at);
#endif
}

// The scales of a skin (sunbeam.app.scene.texture.ScaleRelief): red and green are slopes along u and v, alpha how light the skin is.
uniform sampler2D skinRelief;
// Repetitions of it along u; where along u scales begin; the steepest slope, 0 for none; and what alpha 1 means.
uniform float reliefPerUnit;
uniform float reliefBegin;
uniform float reliefSteepest;
uniform float reliefLightest;

// Where the patch's x points (sunbeam.app.scene.texture.OrientationMap): red along the tangent, green along the bitangent, of 8 bits.
uniform sampler2D patchDirections;

// Cosine and sine of the patch's turn from the tangent about the normal, counter-clockwise seen from outside.
vec2 patchTurn() {
    vec2 along = (255.0 * texelAt(patchDirections, surfaceCoordinate).xy - 128.0) * vec2(1.0, frameHandedness());
    float square = dot(along, along);
    // Where opposite directions meet, they cancel.
    along = square > 1e-6 ? along * inversesqrt(square) : vec2(1.0, 0.0);
    return vec2(along.x * tangentCosine - along.y * tangentSine, along.y * tangentCosine + along.x * tangentSine);
}

vec4 reliefTexel() {
    vec4 texel = texelAt(skinRelief, vec2(reliefPerUnit * surfaceCoordinate.x, surfaceCoordinate.y));
    float share = clamp(60.0 * (surfaceCoordinate.x - reliefBegin) + 0.5, 0.0, 1.0);
    return vec4(share * reliefSteepest * (255.0 * texel.xy - 128.0) / 127.0, 0.0, mix(1.0, texel.w * reliefLightest, share));
}

// The normal with that relief; of any length.
vec3 reliefNormal(vec2 slopes) {
    vec3 bitangent = frameHandedness() * cross(worldNormal, worldTangent.xyz);
    return worldNormal - slopes.x * worldTangent.xyz - slopes.y * bitangent;
}
