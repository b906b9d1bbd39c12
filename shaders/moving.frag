#version 330 core
#define SHADOW_TAPS 4
#define SLICE_TAPS 2
#include "jrtr/lights.glsl"
#include "jrtr/view_rays.glsl"
#include "include/blend.glsl"
#include "include/display.glsl"
#include "include/footprint.glsl"
#include "include/packed_surface.glsl"
#include "include/radiance.glsl"
#include "include/shadow.glsl"
#include "include/sky.glsl"

// A skin that moves, as a screen shows it, under all lights, by those levels of colors that exist: each pixel looks in a few
// places of the finest of them that is fine enough, with fewer taps than final pictures have. It is drawn where the skin is alone.
// LIGHTS: how many there are; software renderers are slower where a loop has turns that are not known.

// moving_geometry.frag's.
uniform sampler2D surfaces;
uniform sampler2D depths;
// From a place in the target and its depth to world space.
uniform mat4 targetToWorld;
// Of relief that is finer than a pixel.
uniform float slopeVariance;
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

// Along the major axis of what the pixel sees, in a level and in PLACES places at most; MISSING where a tile does not exist.
vec3 alongXyz(Footprint footprint, float level) {
    vec4 texel = levelAt(level);
    ColorGrid grid = levelGrid(texel, level);
#if PLACES == 1
    vec3 xyz = linearXyz(footprint.place.xy, footprint.place.z, grid);
    return xyz.y == MISSING ? xyz : texel.w * xyz;
#else
    float step = 1.0 / footprint.wide.w;
    vec3 sum = vec3(0.0);
    for (float at = 0.5 * step - 0.5; at < 0.5; at += step) {
        vec3 uvw = footprint.place.xyz + at * footprint.wide.xyz;
        vec3 xyz = linearXyz(uvw.xy, uvw.z, grid);
        if (xyz.y == MISSING) {
            return xyz;
        }
        sum += xyz;
    }
    return step * texel.w * sum;
#endif
}

vec3 existingXyz(Footprint footprint) {
    for (float level = footprint.place.w; level < float(levels) + pointLevels; level += 1.0) {
        vec3 xyz = alongXyz(footprint, level);
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
    float everywhere = skyShare(skin.frame[2], skin.sky);
    vec3 gloss = glossXyz(skin.frame, wr, skin.sky);
    vec3 sum = vec3(0.0);
    for (int light = 0; light < LIGHTS; ++light) {
        vec3 wi = lightDirection(skin.frame, light);
        vec3 uvw = diffractionVector(wi, wr);
        // Beside pixels of no skin they are nothing, and not used.
        vec3 a = inside(dFdx(uvw), coverageChange.x);
        vec3 b = inside(dFdy(uvw), coverageChange.y);
        vec3 diffracted = vec3(0.0);
        if (wi.z > 0.0 && wr.z > 0.0) {
            diffracted = relativeRadiance(wi, wr) * existingXyz(footprintOf(uvw, a, b, slopeVariance));
        }
        // Nothing shades the others.
        float arrives = 1.0;
        if (light == 0 && wi.z > 0.0) {
            arrives = litShare(worldAt(gl_FragCoord.xy), skin.frame[2]);
        }
        sum += lightRadiances[light].y
                * (blended(arrives * diffracted, albedo, arrives * wi.z, KERATIN_REFLECTANCE, everywhere) + gloss);
    }
    color = vec4(srgbCurveByRoots(displayLight(sum)), 1.0);
}
