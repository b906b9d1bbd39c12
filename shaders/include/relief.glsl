#include "jrtr/tangent_frame.glsl"

// Trilinear texture fetch. With NEAREST_FINER_LEVEL a bilinear fetch from one level, whose texels are 0.35 to 0.71 pixels wide, which takes
// less time. TEXEL_BIAS: added to the level.
vec4 texelAt(sampler2D image, vec2 at) {
#ifdef NEAREST_FINER_LEVEL
    vec2 size = vec2(textureSize(image, 0));
    vec2 a = size * dFdx(at);
    vec2 b = size * dFdy(at);
    // Floor of (log2 of the squared length, less one) / 2, from the float's exponent.
    int level = ((floatBitsToInt(max(dot(a, a), dot(b, b))) >> 23) - 127 - 1) >> 1;
    return textureLod(image, at, float(level));
#elif defined(TEXEL_BIAS)
    return texture(image, at, TEXEL_BIAS);
#else
    return texture(image, at);
#endif
}

// Relief of a skin (sunbeam.app.scene.texture.ScaleRelief), the head's below HEAD_SHARE of the height: red and green are slopes along u and
// v, blue is the share of pale pigment, alpha a factor of the albedo.
uniform sampler2D skinRelief;
// Repetitions of the relief per unit of u; u at which scales begin, behind the head; slope that a channel of 255 encodes, 0 for no scales;
// albedo factor that an alpha of 1 encodes.
uniform float reliefPerUnit;
uniform float reliefBegin;
uniform float reliefSteepest;
uniform float reliefLightest;

// Direction of the patch's x axis (sunbeam.app.scene.texture.Body): red is its component along the tangent, green along the
// bitangent; 128 encodes 0, and any length will do.
uniform sampler2D patchDirections;

// Cosine and sine of the patch's turn from the tangent about the normal, counterclockwise seen from outside.
vec2 patchTurn() {
    vec2 along = (255.0 * texelAt(patchDirections, surfaceCoordinate).xy - 128.0) * vec2(1.0, frameHandedness());
    float square = dot(along, along);
    // Opposite directions can cancel in the texture filter.
    along = square > 1e-6 ? along * inversesqrt(square) : vec2(1.0, 0.0);
    return vec2(along.x * tangentCosine - along.y * tangentSine, along.y * tangentCosine + along.x * tangentSine);
}

const float HEAD_SHARE = 0.2;
// Linear sRGB.
const vec3 PALE = vec3(0.61, 0.52, 0.39);

// Slopes of the relief along u and v (xy), share of pale pigment (z) and factor of the albedo (w). Both reliefs fade out within 1 / 120 of u
// where the head ends.
vec4 reliefTexel() {
    float u = surfaceCoordinate.x;
    float v = surfaceCoordinate.y;
    bool onHead = u < reliefBegin;
    vec2 at = vec2(
            onHead ? u / reliefBegin : reliefPerUnit * u,
            onHead ? HEAD_SHARE * v : HEAD_SHARE + (1.0 - HEAD_SHARE) * v);
    vec4 texel = texelAt(skinRelief, at);
    float share = min(120.0 * abs(u - reliefBegin), 1.0);
    vec2 slopes = share * reliefSteepest * (255.0 * texel.xy - 128.0) / 127.0;
    return vec4(slopes, share * texel.z, mix(1.0, texel.w * reliefLightest, share));
}

// Linear sRGB.
vec3 skinAlbedo(vec4 relief, vec3 color) {
    return relief.w * mix(color, PALE, relief.z);
}

// Visible share of the sky, 0 to 1: a mesh that occludes it has it as the magnitude of worldTangent.w (sunbeam.app.scene.mesh.Mesh).
float visibleSky() {
    return min(abs(worldTangent.w), 1.0);
}

// World-space normal of the relief with slopes along tangent and bitangent; not normalized.
vec3 reliefNormal(vec2 slopes) {
    vec3 bitangent = frameHandedness() * cross(worldNormal, worldTangent.xyz);
    return worldNormal - slopes.x * worldTangent.xyz - slopes.y * bitangent;
}
