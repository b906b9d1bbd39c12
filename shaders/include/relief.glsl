#include "jrtr/tangent_frame.glsl"

// Trilinear texture fetch; with NEAREST_FINER_LEVEL bilinear in one level that is twice as fine, which takes less time.
vec4 texelAt(sampler2D image, vec2 at) {
#ifdef NEAREST_FINER_LEVEL
    vec2 size = vec2(textureSize(image, 0));
    vec2 a = size * dFdx(at);
    vec2 b = size * dFdy(at);
    // Floor of (log2 of the squared length, less one) / 2, from the float's exponent.
    int level = ((floatBitsToInt(max(dot(a, a), dot(b, b))) >> 23) - 127 - 1) >> 1;
    return textureLod(image, at, float(level));
#else
    return texture(image, at);
#endif
}

// Scales of a skin (sunbeam.app.scene.texture.ScaleRelief): red and green are slopes along u and v, alpha a factor of the albedo.
uniform sampler2D skinRelief;
// Repetitions of the relief along u; u at which scales begin; slope of a full channel, 0 for none; albedo factor of alpha 1.
uniform float reliefPerUnit;
uniform float reliefBegin;
uniform float reliefSteepest;
uniform float reliefLightest;

// Direction of the patch's x axis (sunbeam.app.scene.texture.OrientationMap): red along the tangent, green along the bitangent, 8 bits.
uniform sampler2D patchDirections;

// Cosine and sine of the patch's turn from the tangent about the normal, counterclockwise seen from outside.
vec2 patchTurn() {
    vec2 along = (255.0 * texelAt(patchDirections, surfaceCoordinate).xy - 128.0) * vec2(1.0, frameHandedness());
    float square = dot(along, along);
    // Filtering of opposite directions can cancel them.
    along = square > 1e-6 ? along * inversesqrt(square) : vec2(1.0, 0.0);
    return vec2(along.x * tangentCosine - along.y * tangentSine, along.y * tangentCosine + along.x * tangentSine);
}

vec4 reliefTexel() {
    vec4 texel = texelAt(skinRelief, vec2(reliefPerUnit * surfaceCoordinate.x, surfaceCoordinate.y));
    float share = clamp(60.0 * (surfaceCoordinate.x - reliefBegin) + 0.5, 0.0, 1.0);
    return vec4(share * reliefSteepest * (255.0 * texel.xy - 128.0) / 127.0, 0.0, mix(1.0, texel.w * reliefLightest, share));
}

// World-space normal with the relief's slopes; not normalized.
vec3 reliefNormal(vec2 slopes) {
    vec3 bitangent = frameHandedness() * cross(worldNormal, worldTangent.xyz);
    return worldNormal - slopes.x * worldTangent.xyz - slopes.y * bitangent;
}
