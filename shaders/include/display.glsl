#include "include/srgb.glsl"

// Display transform: linear XYZ to linear sRGB of a screen (in double precision: sunbeam.precompute.color.DisplayTransform).

uniform float exposure;
// Largest channel value that is not compressed (sunbeam.precompute.color.DisplayTransform.Tone).
uniform float toneStart;

// A color is mixed half with white if its largest channel is 1 / DESATURATION above the compressed one.
const float DESATURATION = 0.005;
// Largest channel value; brighter colors are treated alike, so that float32 does not overflow.
const float BRIGHTEST = 1e9;

// Moves a color outside of sRGB towards the gray of its luminance until no channel is negative.
vec3 intoGamut(vec3 rgb, float luminance) {
    float least = min(0.0, min(rgb.r, min(rgb.g, rgb.b)));
    return luminance / (luminance - least) * (rgb - least);
}

// Compresses all channels by one factor, so that highlights keep their hue; beyond a hundred times white they fade to white.
vec3 compressed(vec3 rgb) {
    float largest = clamp(max(rgb.r, max(rgb.g, rgb.b)), 1e-30, BRIGHTEST);
    float room = 1.0 - toneStart;
    float peak = largest > toneStart ? 1.0 - room * room / (largest + room - toneStart) : largest;
    float white = 1.0 - 1.0 / (DESATURATION * (largest - peak) + 1.0);
    return peak * mix(rgb / largest, vec3(1.0), white);
}

// Linear sRGB in [0, 1]; black without luminance.
vec3 displayLight(vec3 xyz) {
    vec3 exposed = exposure * xyz;
    return exposed.y > 0.0 ? min(compressed(intoGamut(XYZ_TO_LINEAR_SRGB * exposed, exposed.y)), 1.0) : vec3(0.0);
}
