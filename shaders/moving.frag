#version 330 core
#define SHADOW_TAPS 4
#define SLICE_TAPS 2
#define TAP_FILTER linearXyz
#include "jrtr/lights.glsl"
#include "jrtr/view_rays.glsl"
#include "include/blend.glsl"
#include "include/display.glsl"
#include "include/gain.glsl"
#include "include/loops.glsl"
#include "method/{METHOD}.glsl"
#include "include/packed_surface.glsl"
#include "include/shadow.glsl"
#include "include/sky.glsl"

// A skin that moves, as a screen shows it, under all lights, by the tiles that are resident: a pixel takes the mean over its footprint from
// the finest level that has its tiles, with fewer taps than final pictures have. It is drawn where the skin covers pixels.
// LIGHTS: number of lights, a constant since software renderers are slower otherwise. MOST_TAPS: taps of a footprint.

// moving_geometry.frag's.
uniform sampler2D surfaces;
uniform sampler2D depths;
// From a place in the target and its depth to world space.
uniform mat4 targetToWorld;
// One over its width and height.
uniform vec2 perPicture;

// sRGB in [0, 1].
layout(location = 0) out vec4 color;

vec3 worldAt(vec2 place) {
    vec4 at = targetToWorld * vec4(place, textureLod(depths, place * perPicture, 0.0).r, 1.0);
    return at.xyz / at.w;
}

// Change of (u, v, w) to the pixel beside; none at the skin's edge.
vec3 inside(vec3 change, float coverageChange) {
    return coverageChange == 0.0 ? change : vec3(0.0);
}

// Of the finest level from the footprint's on whose tiles are resident; zero without any.
vec3 residentXyz(Footprint footprint) {
    for (float level = footprint.level; level < float(levels) + pointLevels; level += 1.0) {
        vec3 xyz = levelXyz(footprint, level);
        if (xyz.y < MISSING) {
            return xyz;
        }
    }
    return vec3(0.0);
}

void main() {
    vec4 texel = textureLod(surfaces, gl_FragCoord.xy * perPicture, 0.0);
    float coverage = showsSkin(texel) ? 1.0 : 0.0;
    vec2 coverageChange = vec2(dFdx(coverage), dFdy(coverage));
    Skin skin = unpackedSkin(texel);
    vec3 wr = viewAt(gl_FragCoord.xy) * skin.frame;
    vec3 albedo = LINEAR_SRGB_TO_XYZ * skin.albedo;
    float ambient = skyShare(skin.frame[2], skin.sky);
    vec3 gloss = glossXyz(skin.frame, wr, skin.sky);
    vec3 sum = vec3(0.0);
    for (int light = 0; light < LIGHTS; ++light) {
        vec3 wi = lightDirection(skin.frame, light);
        vec3 uvw = diffractionVector(wi, wr);
        // Pixels without skin have no (u, v, w).
        vec3 du = inside(dFdx(uvw), coverageChange.x);
        vec3 dv = inside(dFdy(uvw), coverageChange.y);
        vec3 diffracted = vec3(0.0);
        if (wi.z > 0.0 && wr.z > 0.0) {
            diffracted = relativeRadiance(wi, wr) * residentXyz(footprintOf(uvw, du, dv));
        }
        // Nothing shades the others.
        float arrives = 1.0;
        if (light == 0 && wi.z > 0.0) {
            arrives = litShare(worldAt(gl_FragCoord.xy), skin.frame[2]);
        }
        sum += lightRadiances[light].y
                * (blended(arrives * diffracted, albedo, arrives * wi.z, KERATIN_REFLECTANCE, ambient) + gloss);
    }
    color = vec4(srgbCurveByRoots(displayLight(sum)), 1.0);
}
