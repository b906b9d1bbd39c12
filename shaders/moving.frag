#version 330 core
#define SHADOW_TAPS 4
#define SHADOW_QUADS
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

// Shading pass of pictures drawn while something moves, under all lights, in sRGB. Each pixel reads its footprint in the finest resident
// level, with fewer taps than in pictures at rest. Runs for pixels that show skin. LIGHTS: number of lights, a define since a loop of
// unknown length slows software renderers. MOST_TAPS: most taps of a footprint.

// The image that moving_geometry.frag writes, and its depth.
uniform sampler2D surfaces;
uniform sampler2D depths;
// Matrix from a pixel's position in the image, in pixels, and its depth to world space.
uniform mat4 targetToWorld;
// One over the size of the images.
uniform vec2 perPicture;

// Luminance, relative to the diffracted light's weight, of light that is spread evenly over all directions; it stands in for missing colors.
uniform float evenLight;
// Number of levels, or 0 while the coarsest one has gaps.
uniform float usableLevels;

// Variance of each light's directions along either axis.
uniform float lightVariances[LIGHTS];

// Color in sRGB; alpha is 1 less the coarsest stand-in, in steps of 255.
layout(location = 0) out vec4 color;

// Level of a stand-in for a finer one of which a tile is not resident; 0 for none.
float standIn = 0.0;

vec3 worldAt(vec2 place) {
    vec4 at = targetToWorld * vec4(place, textureLod(depths, place * perPicture, 0.0).r, 1.0);
    return at.xyz / at.w;
}

// Change of (u, v, w) to the neighboring pixel; zero if only one of the two shows skin.
vec3 inside(vec3 change, float coverageChange) {
    return coverageChange == 0.0 ? change : vec3(0.0);
}

// Color in the finest resident level that is not finer than the footprint's; MISSING if no such level is resident.
vec3 residentXyz(Footprint footprint) {
    for (float level = footprint.level; level < usableLevels; level += 1.0) {
        vec3 xyz = levelXyz(footprint, level);
        if (xyz.y != MISSING) {
            standIn = max(standIn, level > footprint.level ? level : 0.0);
            return xyz;
        }
    }
    return vec3(MISSING);
}

void main() {
    vec4 texel = textureLod(surfaces, gl_FragCoord.xy * perPicture, 0.0);
    float coverage = showsSkin(texel) ? 1.0 : 0.0;
    vec2 coverageChange = vec2(dFdx(coverage), dFdy(coverage));
    Skin skin = unpackedSkin(texel);
    vec3 wr = viewAt(gl_FragCoord.xy) * skin.frame;
    vec3 albedo = belowGloss(wr, skin.sky) * (LINEAR_SRGB_TO_XYZ * skin.albedo);
    float ambient = skyShare(skin.frame[2], skin.sky);
    vec3 gloss = glossXyz(skin.frame, wr, skin.sky);
    vec3 sum = gloss;
    for (int light = 0; light < LIGHTS; ++light) {
        vec3 wi = lightDirection(skin.frame, light);
        vec3 uvw = diffractionVector(wi, wr);
        // Pixels without skin have no (u, v, w).
        vec3 du = inside(dFdx(uvw), coverageChange.x);
        vec3 dv = inside(dFdy(uvw), coverageChange.y);
        vec3 diffracted = vec3(0.0);
        if (skin.hasPatch && wi.z > 0.0 && wr.z > 0.0) {
            ReliefMean mean = reliefMean(wi, wr, tabulatedSlopeVariance + slopeVariance);
            Footprint footprint = footprintOf(mean.uvw, du, dv, wi, lightVariances[light], vec3(0.0), 0.0);
            vec3 made = usableLevels > 0.0 ? residentXyz(footprint) : vec3(MISSING);
            diffracted = made.y == MISSING ? evenLight * wi.z * (LINEAR_SRGB_TO_XYZ * vec3(1.0)) : mean.gain * made;
        }
        // Only the first light casts shadows; an environment's are those of the sky.
        float visible = mix(1.0, skin.sky, isEnvironment);
        if (light == 0) {
            visible *= quadVisibility(0, worldAt(gl_FragCoord.xy), skin.frame[2], coverage * wi.z > 0.0);
        }
        vec3 xyz = blended(visible * diffracted, albedo, visible * wi.z, NORMAL_REFLECTANCE, ambient);
        xyz += visible * lightGloss(wi, wr, skin.sky) * (LINEAR_SRGB_TO_XYZ * vec3(1.0));
        sum += LINEAR_SRGB_TO_XYZ * (lightRadiances[light] * (XYZ_TO_LINEAR_SRGB * xyz));
    }
    color = vec4(srgbCurveByRoots(displayLight(sum)), 1.0 - standIn / 255.0);
}
