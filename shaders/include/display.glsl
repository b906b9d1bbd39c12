#include "include/srgb.glsl"

// From linear XYZ to what a screen shows: exposure, gamut, curve.

// Moves a colour towards the grey of its luminance until every channel lies in [0, 1]: hue and luminance stay, only
// saturation goes. What is brighter than white becomes white.
vec3 intoGamut(vec3 rgb, float luminance) {
    float grey = clamp(luminance, 0.0, 1.0);
    vec3 chroma = rgb - luminance;
    float above = max(max(chroma.r, chroma.g), max(chroma.b, 1e-30));
    float below = max(max(-chroma.r, -chroma.g), max(-chroma.b, 1e-30));
    float keep = min(1.0, min((1.0 - grey) / above, grey / below));
    // Chroma of light beyond white is of no use, and not a number where the light is infinite.
    return luminance >= 1.0 ? vec3(1.0) : clamp(grey + keep * chroma, 0.0, 1.0);
}

// What a screen shows as light, before its curve: linear sRGB in [0, 1].
vec3 displayLight(vec3 xyz, float exposure) {
    vec3 exposed = exposure * xyz;
    return intoGamut(XYZ_TO_LINEAR_SRGB * exposed, exposed.y);
}

vec3 displayColor(vec3 xyz, float exposure) {
    return srgbCurve(displayLight(xyz, exposure));
}
