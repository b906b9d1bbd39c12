#version 330 core
#include "jrtr/lights.glsl"
#include "include/blend.glsl"
#include "include/gain.glsl"
#include "include/geometry.glsl"
#include "include/loops.glsl"
#include "include/neighbors.glsl"
#include "include/sky.glsl"
#include "method/{METHOD}.glsl"

// A skin under one light: diffraction, texture and diffuse part, from what geometry.frag found in each pixel.
// COLOR_LEVELS: 1 where the method is table_levels, whose colors are means over footprints; 0 for methods that see points.

// Number of the texel of geometry.frag's images that each pixel lights, counted row by row; negative for none.
uniform sampler2D sources;
#if COLOR_LEVELS == 1
// Pixels along a side of what each stands for.
uniform float stride;
// 1 to look colors up; 0 to find the footprints alone, whose tiles are not resident yet.
uniform int lookUps;
#else
// Of relief that is finer than a pixel, for methods that see points: standard deviation of its slopes along either axis, and the number of
// this draw, whose pixels have one slope each; pictures are means of draws.
uniform float slopeDeviation;
uniform int slopeDraw;
#endif

// Far above any light: a color that a table lacks (include/color_table.glsl) is brighter still.
const float BRIGHTEST = 1e15;

// Linear XYZ; alpha 1, the skin's coverage, or -1 where a tile was not resident (sunbeam.app.scene.SkinLevels).
layout(location = 0) out vec4 radiance;
#if COLOR_LEVELS == 1
// The footprint (include/footprint.glsl): its center and level, -1 where nothing is diffracted; its axis and the number of taps.
layout(location = 1) out vec4 footprintCenter;
layout(location = 2) out vec4 footprintAxis;


// Relative radiance of the pixel's footprint.
vec3 footprintRadiance(vec3 wi, vec3 wr, ivec2 pixel) {
    vec3 uvw = diffractionVector(wi, wr);
    vec3 du = stride * uvwChange(pixel, ivec2(1, 0), uvw);
    vec3 dv = stride * uvwChange(pixel, ivec2(0, 1), uvw);
    Footprint footprint = footprintOf(uvw, du, dv);
    footprintCenter = vec4(footprint.center, footprint.level);
    footprintAxis = vec4(footprint.axis, footprint.taps);
    vec3 xyz = vec3(MISSING);
    for (int i = 0; i < lookUps; ++i) {
        xyz = footprintXyz(footprint);
    }
    return relativeRadiance(wi, wr) * xyz;
}
#else
// Relative radiance at a point.
vec3 pointRadiance(vec3 wi, vec3 wr) {
    vec3 xyz = relativeRadiance(wi, wr) * diffractedXyz(diffractionVector(wi, wr));
    return loopsWereCut() ? vec3(LOOPS_CUT) : xyz;
}

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

// Whether anything is diffracted: not where light or viewer lies in or below the tangent plane, as relief in the normals can have it, nor
// where the body alone is drawn, which then costs little.
bool isDiffracted(vec3 wi, vec3 wr) {
    return diffractionWeight != 0.0 && wi.z > 0.0 && wr.z > 0.0;
}

void main() {
    // Pixels without a source shade pixel 0 and are never read back. No discard: on Mesa's software renderer it would leave loops a
    // sixteenth of their steps (include/loops.glsl).
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
    float ambient = skyShare(normal.xyz, seen.w);
    vec3 wi = lightDirection(frame, 0);
    vec3 diffracted = vec3(0.0);
    float weight = 1.0;
#if COLOR_LEVELS == 1
    footprintCenter = vec4(0.0, 0.0, 0.0, -1.0);
    footprintAxis = vec4(0.0);
    if (hasPatch && isDiffracted(wi, wr)) {
        diffracted = footprintRadiance(wi, wr, pixel);
    }
#else
    vec2 numbers = slopeNumbers(pixel);
    weight = slopeDeviation > 0.0 ? exp(-0.5 * (WIDER * WIDER - 1.0) * dot(numbers, numbers)) : 1.0;
    mat3 relief = reliefFrame(WIDER * slopeDeviation * numbers);
    if (hasPatch && isDiffracted(wi * relief, wr * relief)) {
        diffracted = pointRadiance(wi * relief, wr * relief);
    }
#endif
    // Luminance says all: the body is lit as by daylight, whatever spectrum colors the diffracted light.
    float reflectance = schlickReflectance(halfAngleCosine(wi, wr));
    vec3 sum = blended(lit.a * diffracted, albedo, lit.a * wi.z, reflectance, ambient) + glossXyz(frame, wr, seen.w);
    sum *= lightRadiances[0].y;
    radiance = weight * vec4(sum, sum.y > BRIGHTEST ? -1.0 : 1.0);
}
