#include "include/light_list.glsl"

// Shadows of groups of lights (app.render.LightList): a depth map for each with percentage-closer filtering (Reeves et al. 1987); the penumbra
// widens with the distance of the occluder (Fernando 2005).

// Depth of the first surface that the light meets, 0 to 1, in tiles, one for each group.
uniform sampler2D shadowMap;

// Number of the sample, from 1, in a picture that is the mean of several; 0 in one without.
uniform float shadowSample;

// SHADOW_TAPS: texels of the map that are compared; a define, so that compilers unroll the loops. SHADOW_PARTS: 4 where each of four
// neighboring samples has every fourth tap of the disc. SHADOW_QUADS: defined by shaders that call quadVisibility.
#ifndef SHADOW_PARTS
#define SHADOW_PARTS 1
#endif

// Depth, as a share of the map's range, by which a shaded surface lies behind the map's at least, so that a surface does not shade itself.
const float SHADOW_BIAS = 0.002;
// Radius of the filter, as a share of the map's side: the smallest, and the largest per penumbra, the radius per depth from occluder to
// surface. Where several groups share the image their maps are half as fine.
const float SHARPEST = 0.0016;
const float SOFTEST = 0.4;
// Half a texel of a small map, as a share of its side.
const float SHADOW_EDGE = 0.0016;

// Taps spread evenly over the unit disc (Vogel 1979): each is turned by the golden angle from the one before. Occluders are searched at every
// SEARCH_STEP-th of a sample's own.
const float GOLDEN_ANGLE = 2.39996323;
const float TAP_ANGLE = GOLDEN_ANGLE * float(SHADOW_PARTS);
const mat2 TAP_TURN = mat2(cos(TAP_ANGLE), sin(TAP_ANGLE), -sin(TAP_ANGLE), cos(TAP_ANGLE));
const int SEARCH_STEP = SHADOW_PARTS == 1 ? 2 : 1;

#if SHADOW_PARTS > 1
// Number of a sample's first tap.
float firstTap(vec2 pixel) {
    vec2 odd = mod(floor(pixel), 2.0);
    return odd.x + 2.0 * odd.y;
}

vec2 firstOnDisc(vec2 pixel) {
    float angle = GOLDEN_ANGLE * firstTap(pixel);
    return vec2(cos(angle), sin(angle));
}
#else
float firstTap(vec2 pixel) {
    return 0.0;
}
#endif

#ifdef SHADOW_QUADS
// Direction of the first tap: one of four turns for each fragment of a square of 2 x 2 (quadVisibility).
vec2 firstOnDisc(vec2 pixel) {
    vec2 odd = mod(floor(pixel), 2.0);
    float angle = 1.57079633 * (odd.x + 2.0 * odd.y) + GOLDEN_ANGLE * shadowSample;
    return vec2(cos(angle), sin(angle));
}
#elif SHADOW_PARTS == 1
// Direction of the first tap; it differs from pixel to pixel (Jimenez 2014), which hides banding.
vec2 firstOnDisc(vec2 pixel) {
    float angle = 6.28318531 * fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))) + 0.61803399 * shadowSample);
    return vec2(cos(angle), sin(angle));
}
#endif

// Depth at a position of a group's map, 0 to 1 along either side; clamped, since other groups' tiles lie beside it.
float shadowDepth(vec2 at, vec4 tile) {
    return textureLod(shadowMap, tile.xy + tile.z * clamp(at, SHADOW_EDGE, 1.0 - SHADOW_EDGE), 0.0).r;
}

// Share of a group's light that reaches a point, world space; pixel: its place in the picture.
float visibility(int group, vec3 world, vec3 normal, vec2 pixel) {
    vec4 own = lightTexel(group, GROUP_LIGHTS);
    float visible = 1.0;
    // A loop of one iteration: software renderers skip it where no pixel enters it.
    for (float shadowed = own.z; shadowed > 0.0; shadowed = 0.0) {
        vec4 tile = lightTexel(group, GROUP_TILE);
        mat4 worldToShadow = mat4(
                lightTexel(group, GROUP_MATRIX),
                lightTexel(group, GROUP_MATRIX + 1),
                lightTexel(group, GROUP_MATRIX + 2),
                lightTexel(group, GROUP_MATRIX + 3));
        vec4 clip = worldToShadow * vec4(world + own.w * normal, 1.0);
        vec3 at = 0.5 * clip.xyz / clip.w + 0.5;
        float softest = SOFTEST * tile.w;
        if (any(greaterThan(abs(at.xy - 0.5), vec2(0.5 + softest)))) {
            break;
        }
        float depth = min(at.z, 1.0) - SHADOW_BIAS;
        const float perCount = 1.0 / float(SHADOW_TAPS * SHADOW_PARTS);
        float firstNumber = firstTap(pixel) + 0.5;
        vec2 first = firstOnDisc(pixel);
        float nearer = 0.0;
        float hidden = 0.0;
        vec2 direction = softest * first;
        for (int tap = 0; tap < SHADOW_TAPS; tap += SEARCH_STEP) {
            vec2 off = sqrt((float(SHADOW_PARTS * tap) + firstNumber) * perCount) * direction;
            float above = depth - shadowDepth(at.xy + off, tile);
            hidden += above > 0.0 ? 1.0 : 0.0;
            nearer += max(above, 0.0);
            direction = SEARCH_STEP == 1 ? TAP_TURN * direction : TAP_TURN * (TAP_TURN * direction);
        }
        float sharpest = tile.z < 1.0 ? 2.0 * SHARPEST : SHARPEST;
        direction = clamp(tile.w * nearer / max(hidden, 1.0), sharpest, softest) * first;
        float dark = 0.0;
        for (int tap = 0; tap < SHADOW_TAPS; ++tap) {
            vec2 off = sqrt((float(SHADOW_PARTS * tap) + firstNumber) * perCount) * direction;
            dark += shadowDepth(at.xy + off, tile) < depth ? 1.0 : 0.0;
            direction = TAP_TURN * direction;
        }
        visible = 1.0 - dark / float(SHADOW_TAPS);
    }
    return visible;
}

#ifdef SHADOW_QUADS
// Sum over the square of 2 x 2 fragments that are shaded together.
vec2 quadSum(vec2 value) {
    vec2 toOther = 1.0 - 2.0 * mod(floor(gl_FragCoord.xy), 2.0);
    vec2 row = 2.0 * value + toOther.x * dFdx(value);
    return 2.0 * row + toOther.y * dFdy(row);
}

// Mean visibility of the lit fragments of a square. All squares have the same taps, so that edges of shadows have no grain; a sample of
// several has its own visibility, since its taps differ from those of the others. To be called by all fragments, with isLit false where no
// light arrives anyway.
float quadVisibility(int group, vec3 world, vec3 normal, bool isLit) {
    vec2 own = vec2(0.0);
    if (isLit) {
        own = vec2(visibility(group, world, normal, gl_FragCoord.xy), 1.0);
    }
    vec2 sum = shadowSample > 0.0 ? own : quadSum(own);
    return sum.y > 0.5 ? sum.x / sum.y : 1.0;
}
#endif
