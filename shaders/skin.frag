#version 330 core
#include "jrtr/lights.glsl"
#include "include/blend.glsl"
#include "include/geometry.glsl"
#include "include/radiance.glsl"
#include "include/sky.glsl"

// A skin under one light: diffraction, texture and diffuse part, from what geometry.frag found in each pixel.

// Number of the texel of geometry.frag's images that each pixel lights, counted row by row; negative for none.
uniform sampler2D sources;
#if POINT_SLOPES == 1
// Of relief that is finer than a pixel, for methods that see points: standard deviation of its slopes along either axis, and the number of
// this draw, whose pixels have one slope each; pictures are means of draws.
uniform float slopeDeviation;
uniform int slopeDraw;
#endif

// Far above any light: a color that a table lacks (include/color_table.glsl) is brighter still.
const float BRIGHTEST = 1e15;

// Linear XYZ; alpha 1, the skin's coverage, or -1 where a color was missing (sunbeam.app.scene.SkinFootprints).
layout(location = 0) out vec4 radiance;

// Where light or viewer lies in or below the tangent plane, as relief in the normals can have it, nothing is diffracted; nor where the
// body alone is asked for, which then costs little.
vec3 diffractedTowards(vec3 wi, vec3 wr) {
    if (diffractionWeight == 0.0 || wi.z <= 0.0 || wr.z <= 0.0) {
        return vec3(0.0);
    }
    return diffractedRadiance(wi, wr);
}

#if POINT_SLOPES == 1
// The value below which a normally distributed number is with this probability (Winitzki 2008; to 2e-3 of it).
vec2 quantile(vec2 probability) {
    vec2 x = 2.0 * probability - 1.0;
    vec2 logs = log(1.0 - x * x);
    vec2 t = 2.0 / (3.14159265 * 0.147) + 0.5 * logs;
    return sign(x) * sqrt(2.0 * (sqrt(t * t - logs / 0.147) - t));
}

// Slopes are drawn this much wider than they lie, and weighed, so that the rare ones that meet a bright order are met often.
const float WIDER = 1.6;

// Standard normal numbers along either axis for this draw of a pixel.
vec2 slopeNumbers(ivec2 pixel) {
    // A low-discrepancy sequence along 16 x 16 pixels and further draws (Roberts 2018).
    uint number = uint((pixel.x & 15) + 16 * (pixel.y & 15) + 256 * slopeDraw);
    vec2 at = vec2(number * uvec2(3242174889u, 2447445414u) + 0x80000000u) * exp2(-32.0);
    return quantile(clamp(at, 1e-5, 1.0 - 1e-5));
}

// A frame within the tangent frame, of relief with that slope.
mat3 reliefFrame(vec2 slope) {
    vec3 normal = normalize(vec3(slope, 1.0));
    vec3 along = normalize(vec3(1.0, 0.0, 0.0) - normal.x * normal);
    return mat3(along, cross(normal, along), normal);
}
#endif

void main() {
    // What there is no texel for, nobody reads. A discard would leave loops a sixteenth of their steps on Mesa's software renderer
    // (include/loops.glsl).
    int source = max(0, int(texelFetch(sources, ivec2(gl_FragCoord.xy), 0).r));
    int width = textureSize(views, 0).x;
    ivec2 pixel = ivec2(source % width, source / width);
    vec4 view = texelFetch(views, pixel, 0);
    vec3 wr = view.xyz;
    bool hasPatch = view.w == 2.0;
    vec4 normal = texelFetch(normals, pixel, 0);
    vec4 seen = texelFetch(tangents, pixel, 0);
    vec3 tangent = seen.xyz;
    mat3 frame = mat3(tangent, normal.w * cross(normal.xyz, tangent), normal.xyz);
    vec4 lit = texelFetch(albedos, pixel, 0);
    vec3 albedo = LINEAR_SRGB_TO_XYZ * lit.rgb;
    float everywhere = skyShare(normal.xyz, seen.w);
    vec3 wi = lightDirection(frame, 0);
    vec3 diffracted = vec3(0.0);
    float weight = 1.0;
#if POINT_SLOPES == 1
    vec2 numbers = slopeNumbers(pixel);
    weight = slopeDeviation > 0.0 ? exp(-0.5 * (WIDER * WIDER - 1.0) * dot(numbers, numbers)) : 1.0;
#endif
    if (hasPatch) {
#if POINT_SLOPES == 1
        mat3 relief = reliefFrame(WIDER * slopeDeviation * numbers);
        diffracted = diffractedTowards(wi * relief, wr * relief);
#else
        diffracted = diffractedTowards(wi, wr);
#endif
    }
    // Luminance says all: the body is lit as by daylight, whatever spectrum colors the diffracted light.
    float reflectance = schlickReflectance(halfAngleCosine(wi, wr));
    vec3 sum = blended(lit.a * diffracted, albedo, lit.a * wi.z, reflectance, everywhere) + glossXyz(frame, wr, seen.w);
    sum *= lightRadiances[0].y;
    radiance = weight * vec4(sum, sum.y > BRIGHTEST ? -1.0 : 1.0);
}
