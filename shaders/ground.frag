#version 330 core
#if SCREEN == 1
#define SHADOW_TAPS 4
#define SHADOW_QUADS
#else
#define SHADOW_TAPS 16
#endif
#include "jrtr/view_rays.glsl"
#include "include/blend.glsl"
#include "include/shadow.glsl"
#include "include/sky.glsl"
#include "include/srgb.glsl"
#if SCREEN == 1
#include "include/display.glsl"
#endif

// An environment behind a mesh, and an opaque plane under it, with the mesh's shadow and occlusion of the sky; the plane fades to the horizon's color with
// distance, and that color to the background with height.

// SCREEN: 1 to write sRGB for pictures drawn while something moves, 0 to write linear XYZ.

// World space: the eye; the plane's center; two orthogonal vectors in the plane, as long as the half side of the square that groundSky
// covers; the plane's unit normal.
uniform vec3 eye;
uniform vec3 groundMiddle;
uniform vec3 groundAcross;
uniform vec3 groundAlong;
uniform vec3 groundNormal;
// Number of pixels, as viewAt of jrtr/view_rays.glsl counts them, along the side of one fragment.
uniform float viewPixels;
// Linear sRGB.
uniform vec3 groundColor;
uniform vec3 horizonColor;
// 1 or 0.
uniform float showsGround;
uniform float showsEnvironment;
// Radiance of all lights, and of the white ground under each group of lights without shadows, linear Rec. 709.
uniform vec3 groundAmbient;
uniform vec3 groundLights[MOST_GROUPS];
// Share of the sky that the mesh leaves visible, over the square of groundAcross and groundAlong.
uniform sampler2D groundSky;
#if SCREEN == 1
// Background, linear sRGB.
uniform vec3 behind;
#endif

// Linear XYZ and coverage, 1 or 0; with SCREEN opaque sRGB.
layout(location = 0) out vec4 color;

// One over the sine of the elevation at which 37 % of the horizon's light is left.
const float GLOW = 8.0;

float noise(vec2 at) {
    vec2 cell = floor(at);
    vec2 t = at - cell;
    t = t * t * (3.0 - 2.0 * t);
    vec4 corners = cell.x + vec4(0.0, 1.0, 0.0, 1.0) + 157.0 * (cell.y + vec4(0.0, 0.0, 1.0, 1.0));
    vec4 values = fract(0.1031 * corners);
    values *= values + 33.33;
    values = 2.0 * fract(2.0 * values * values) - 1.0;
    return mix(mix(values.x, values.y, t.x), mix(values.z, values.w, t.x), t.y);
}


vec4 ground() {
    vec3 towards = viewAt(viewPixels * gl_FragCoord.xy);
    float height = dot(eye - groundMiddle, groundNormal);
    float slant = dot(towards, groundNormal);
    vec3 horizon = LINEAR_SRGB_TO_XYZ * horizonColor;
    bool isSky = showsGround == 0.0 || height <= 0.0 || slant <= 1e-4;
    if (showsEnvironment > 0.0) {
        horizon = skyXyz(isSky ? -towards : vec3(-towards.xy, 0.0));
    }
    vec3 at = eye - height / max(slant, 1e-4) * towards;
    vec2 place = vec2(
            dot(at - groundMiddle, groundAcross) / dot(groundAcross, groundAcross),
            dot(at - groundMiddle, groundAlong) / dot(groundAlong, groundAlong));
    float sky = textureLod(groundSky, 0.5 * place + 0.5, 0.0).r;
    float beyond = max(dot(place, place) - 0.1, 0.0);
    float fade = 1.0 / (1.0 + 1.6 * beyond * beyond + 0.7 * beyond);
    vec3 direct = vec3(0.0);
    for (int group = 0; group < lightGroups; ++group) {
#if SCREEN == 1
        float visible = quadVisibility(group, at, groundNormal, !isSky);
#else
        float visible = isSky ? 1.0 : visibility(group, at, groundNormal, gl_FragCoord.xy);
#endif
        direct += visible * groundLights[group];
    }
    if (isSky) {
        float glow = height > 0.0 && horizonColor.g > 0.0 ? exp(GLOW * min(slant, 0.0)) : 0.0;
        return max(glow, showsEnvironment) * vec4(horizon, 1.0);
    }
    float grain = 1.0 + 0.06 * noise(9.0 * place) + 0.05 * noise(41.0 * place) + 0.05 * noise(170.0 * place);
    vec3 lit = grain * (ambientWeight * sky * groundAmbient + diffuseWeight * (0.4 + 0.6 * sky) * direct);
    return vec4(mix(horizon, LINEAR_SRGB_TO_XYZ * (lit * groundColor), fade), 1.0);
}

void main() {
#if SCREEN == 1
    vec4 seen = ground();
    color = vec4(srgbCurveByRoots(min(displayLight(seen.xyz) + (1.0 - seen.a) * behind, 1.0)), 1.0);
#else
    color = ground();
#endif
}
