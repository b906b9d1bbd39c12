#version 330 core
#if LIGHT_STRIDE == 1
#define SHADOW_TAPS 16
#else
#define SHADOW_TAPS 4
#define SHADOW_PARTS LIGHT_STRIDE
#endif
#include "include/blend.glsl"
#include "include/gain.glsl"
#include "include/geometry.glsl"
#include "include/loops.glsl"
#include "include/neighbors.glsl"
#include "include/shadow.glsl"
#include "include/sky.glsl"
#include "method/{METHOD}.glsl"

// Shading pass: radiance of a skin under a picture's lights (diffracted light, body color and reflected sky) from geometry.frag's images.
// COLOR_LEVELS: 1 for method table_levels, whose colors are means over footprints; 0 for methods that evaluate points. LIGHT_STRIDE: 4 if each
// of four neighboring samples has every fourth light and every fourth tap of shadows, in place of all; else 1.

// Lights that are drawn: those from the first to the one before the last. Methods that evaluate points draw one light at a time.
uniform int firstLight;
uniform int lastLight;
// 1 if a draw of a pixel has one of the lights, in place of all.
uniform int lightsAreDrawn;
// Depth of geometry.frag's images, and the matrix from a position in them, in pixels, and its depth to world space.
uniform sampler2D depths;
uniform mat4 targetToWorld;

// Number of the patch whose light is drawn, as in geometry.frag.
uniform float drawnPatch;

// For each fragment the index of the texel of geometry.frag's images that it shades, counted row by row; negative for none.
uniform sampler2D sources;
#if COLOR_LEVELS == 1
// Side of the square that a sample stands for, in pixels of geometry.frag's images.
uniform float footprintScale;
// 1 to look colors up; 0 to write footprints only, as feedback for tiles that are not resident yet.
uniform int lookUps;
// Level of the footprints that are written: 0 for their own, 1 for the next, which pixels under a wide light read, too.
uniform float nextLevel;
#else
// Standard deviation, along either axis, of the slopes of relief finer than a pixel, and index of the draw. A pixel has one random slope
// per draw; the picture is the mean of all draws.
uniform float slopeDeviation;
uniform int slopeDraw;
#endif

// Coverage of a pixel whose color is missing (MISSING in include/color_table.glsl), because a tile is not resident.
const float MISSING_COVERAGE = -1.0;

// Linear XYZ and coverage (sunbeam.app.render.PackedShading): 1, or MISSING_COVERAGE, with which XYZ lacks the diffracted light. In
// pictures of several draws both are multiplied by the draw's weight.
layout(location = 0) out vec4 radiance;
#if COLOR_LEVELS == 1
// Footprint (include/footprint.glsl): center and level, -1 where nothing is diffracted; axis and number of taps.
layout(location = 1) out vec4 footprintCenter;
layout(location = 2) out vec4 footprintAxis;

// XYZ of the power of the pixel's footprint around uvw, the mean over relief; MISSING where a tile is not resident. du, dv, stretch: as
// footprintOf of include/footprint.glsl.
vec3 pixelXyz(vec3 wi, vec3 uvw, vec3 du, vec3 dv, float lightVariance, vec3 stretch) {
    Footprint footprint = footprintOf(uvw, du, dv, wi, lightVariance, stretch, nextLevel);
    footprintCenter = vec4(footprint.center, footprint.level);
    footprintAxis = vec4(footprint.axis, footprint.taps);
    vec3 xyz = vec3(MISSING);
    for (int i = 0; i < lookUps; ++i) {
        xyz = footprintXyz(footprint);
    }
    // A loop of one iteration, as in footprintXyz.
    for (float share = footprint.nextShare * float(lookUps); share > 0.0; share = 0.0) {
        vec3 next = footprintXyz(footprintOf(uvw, du, dv, wi, lightVariance, stretch, 1.0));
        xyz = xyz.y == MISSING || next.y == MISSING ? vec3(MISSING) : mix(xyz, next, share);
    }
    return xyz;
}
#else
vec3 pointRadiance(vec3 wi, vec3 wr) {
    vec3 xyz = relativeRadiance(wi, wr) * diffractedXyz(diffractionVector(wi, wr));
    return loopsWereCut() ? vec3(LOOPS_CUT) : xyz;
}

// Quantile of the standard normal distribution (Winitzki 2008), relative error 2e-3.
vec2 quantile(vec2 probability) {
    vec2 x = 2.0 * probability - 1.0;
    vec2 logs = log(1.0 - x * x);
    vec2 t = 2.0 / (3.14159265 * 0.147) + 0.5 * logs;
    return sign(x) * sqrt(2.0 * (sqrt(t * t - logs / 0.147) - t));
}

// Importance sampling. Half of the draws aim at the slope that mirrors the light to the viewer, where a sharp order is far brighter than
// others: their deviation is this share of the relief's.
const float AIMED = 0.125;
// Where that slope is too rare, more deviations from 0, draws are wider than the relief, so that rare slopes that meet other bright orders
// are drawn more often.
const float RAREST = 4.0;
const float WIDER = 1.6;

// Counts through squares of 16 x 16 pixels, then through draws.
uint sampleNumber(ivec2 pixel) {
    return uint((pixel.x & 15) + 16 * (pixel.y & 15) + 256 * slopeDraw);
}

// From 0 to below 1: steps of the golden ratio.
float drawnNumber(ivec2 pixel) {
    return float((sampleNumber(pixel) * 2654435769u) >> 8u) * exp2(-24.0);
}

vec2 normalNumbers(ivec2 pixel, uvec2 steps) {
    // An additive low-discrepancy sequence.
    vec2 at = vec2(sampleNumber(pixel) * steps + 0x80000000u) * exp2(-32.0);
    return quantile(clamp(at, 1e-5, 1.0 - 1e-5));
}

// A direction of the light, whose middle is wi, for this draw of a pixel.
vec3 lightSample(vec3 wi, ivec2 pixel, float lightVariance) {
    // Fractions of the square roots of 2 and 3: independent of the steps for slopes.
    vec2 numbers = sqrt(lightVariance) * normalNumbers(pixel, uvec2(1779033703u, 3144134277u));
    vec3 across = normalize(cross(wi, abs(wi.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    return normalize(wi + numbers.x * across + numbers.y * cross(wi, across));
}

// Normal density of slopes, but for a factor.
float density(vec2 slope, float deviation) {
    return exp(-0.5 * dot(slope, slope) / (deviation * deviation)) / (deviation * deviation);
}

// A slope (xy), and its weight (z): its density over that of the draws. mirror: the slope that mirrors the light to the viewer.
vec3 slopeSample(vec2 numbers, vec2 mirror) {
    if (slopeDeviation == 0.0) {
        return vec3(0.0, 0.0, 1.0);
    }
    if (length(mirror) > RAREST * slopeDeviation) {
        return vec3(WIDER * slopeDeviation * numbers, WIDER * WIDER * exp(-0.5 * (WIDER * WIDER - 1.0) * dot(numbers, numbers)));
    }
    float narrow = AIMED * slopeDeviation;
    vec2 slope = (slopeDraw & 1) == 1 ? mirror + narrow * numbers : slopeDeviation * numbers;
    float relief = density(slope, slopeDeviation);
    return vec3(slope, 2.0 * relief / (relief + density(slope - mirror, narrow)));
}

// Tangent frame of relief with a slope, as columns in the skin's tangent frame.
mat3 reliefFrame(vec2 slope) {
    vec3 normal = normalize(vec3(slope, 1.0));
    vec3 along = normalize(vec3(1.0, 0.0, 0.0) - normal.x * normal);
    return mat3(along, cross(normal, along), normal);
}
#endif

// False if light or viewer is below the tangent plane, which relief can tilt, or if only the body is drawn.
bool isDiffracted(vec3 wi, vec3 wr) {
    return diffractionWeight != 0.0 && wi.z > 0.0 && wr.z > 0.0;
}

vec3 worldAt(ivec2 pixel) {
    vec4 at = targetToWorld * vec4(vec2(pixel) + 0.5, texelFetch(depths, pixel, 0).r, 1.0);
    return at.xyz / at.w;
}

void main() {
    // Pixels without a source shade pixel 0 and are never read back. No discard: on Mesa's software renderer it would leave loops a
    // sixteenth of their steps (include/loops.glsl).
    int source = max(0, int(texelFetch(sources, ivec2(gl_FragCoord.xy), 0).r));
    int width = textureSize(views, 0).x;
    ivec2 pixel = ivec2(source % width, source / width);
    vec4 view = texelFetch(views, pixel, 0);
    vec3 wr = view.xyz;
    bool hasPatch = view.w == drawnPatch;
    vec3 world = worldAt(pixel);
    vec4 seen = texelFetch(tangents, pixel, 0);
    mat3 frame = frameAt(pixel);
    vec3 albedo = belowGloss(wr, seen.w) * (LINEAR_SRGB_TO_XYZ * texelFetch(albedos, pixel, 0).rgb);
    float ambient = skyShare(frame[2], seen.w);
    vec3 gloss = glossXyz(frame, wr, seen.w);
    float weight = 1.0;
    float coverage = 1.0;
    int first = firstLight;
    int last = lastLight;
    float parts = float(LIGHT_STRIDE);
    int phase = LIGHT_STRIDE == 1 ? 0 : (pixel.x & 1) + 2 * (pixel.y & 1);
#if COLOR_LEVELS == 1
    footprintCenter = vec4(0.0, 0.0, 0.0, -1.0);
    footprintAxis = vec4(0.0);
    PixelChange right = changeTo(pixel, ivec2(1, 0), frame, wr);
    PixelChange left = changeTo(pixel, ivec2(-1, 0), frame, wr);
    PixelChange above = changeTo(pixel, ivec2(0, 1), frame, wr);
    PixelChange below = changeTo(pixel, ivec2(0, -1), frame, wr);
#else
    if (lightsAreDrawn == 1) {
        parts = float(last);
        first = int(parts * drawnNumber(pixel));
        last = first + 1;
    }
    // Roberts's sequence (2018).
    vec2 numbers = normalNumbers(pixel, uvec2(3242174889u, 2447445414u));
    vec3 both = max(vec3(-2.0, -2.0, 1e-3), lightTexel(first, LIGHT_TOWARDS).xyz * frame + wr);
    vec3 slope = slopeSample(numbers, both.xy / both.z);
    weight = slope.z;
    mat3 relief = reliefFrame(slope.xy);
#endif
    // Linear Rec. 709. The body is lit by the lights' colors, as if by daylight; only diffracted light has the illuminant's spectrum.
    vec3 sum = vec3(0.0);
    for (int group = 0; group < lightGroups; ++group) {
        vec4 lights = lightTexel(group, GROUP_LIGHTS);
        int end = min(int(lights.y), last);
        int begin = max(int(lights.x), first);
        float visible = 1.0;
        for (bool used = begin < end; used; used = false) {
            visible = visibility(group, world, frame[2], vec2(pixel) + 0.5);
        }
        for (int light = begin + ((phase - begin) & (LIGHT_STRIDE - 1)); light < end; light += LIGHT_STRIDE) {
            vec4 towards = lightTexel(light, LIGHT_TOWARDS);
            vec3 wi = towards.xyz * frame;
            vec3 diffracted = vec3(0.0);
#if COLOR_LEVELS == 1
            // A loop of one iteration, as in footprintXyz.
            for (bool lit = hasPatch && isDiffracted(wi, wr); lit; lit = false) {
                vec3 du = footprintScale * uvwChange(right, left, towards.xyz);
                vec3 dv = footprintScale * uvwChange(above, below, towards.xyz);
                ReliefMean mean = reliefMean(wi, wr, tabulatedSlopeVariance + slopeVariance);
                vec3 xyz = pixelXyz(wi, mean.uvw, du, dv, towards.w, lightTexel(light, LIGHT_STRETCH).xyz * frame);
                coverage = xyz.y == MISSING ? MISSING_COVERAGE : coverage;
                diffracted = xyz.y == MISSING ? vec3(0.0) : mean.gain * xyz;
            }
#else
            vec3 from = towards.w > 0.0 ? lightSample(wi, pixel, towards.w) : wi;
            if (hasPatch && isDiffracted(from * relief, wr * relief)) {
                diffracted = pointRadiance(from * relief, wr * relief);
            }
#endif
            float reflectance = schlickReflectance(halfAngleCosine(wi, wr));
            vec3 xyz = blended(visible * diffracted, albedo, visible * wi.z, reflectance, ambient);
            for (bool mirrored = isEnvironment == 0.0; mirrored; mirrored = false) {
                xyz += visible * lightGloss(wi, wr, seen.w) * (LINEAR_SRGB_TO_XYZ * vec3(1.0));
            }
            sum += parts * lightTexel(light, LIGHT_COLOR).rgb * (XYZ_TO_LINEAR_SRGB * xyz);
        }
    }
    // The first of several passes shows the gloss.
    radiance = weight * vec4(LINEAR_SRGB_TO_XYZ * sum + (firstLight == 0 ? 1.0 : 0.0) * gloss, coverage);
}
