// Linear XYZ to sRGB (IEC 61966-2-1).

vec3 xyzToLinearSrgb(vec3 xyz) {
    // Inverse of the sRGB primaries with the white of D65, as in the standard; columns of X, Y, Z.
    const mat3 TO_SRGB = mat3(
            3.2404542, -0.9692660, 0.0556434,
            -1.5371385, 1.8760108, -0.2040259,
            -0.4985314, 0.0415560, 1.0572252);
    return TO_SRGB * xyz;
}

// Moves a colour towards the grey of its luminance until every channel lies in [0, 1]: hue and luminance stay, only
// saturation goes. What is brighter than white becomes white.
vec3 intoGamut(vec3 rgb, float luminance) {
    float grey = clamp(luminance, 0.0, 1.0);
    vec3 chroma = rgb - luminance;
    vec3 room = mix(vec3(-grey), vec3(1.0 - grey), greaterThan(chroma, vec3(0.0)));
    float keep = 1.0;
    for (int c = 0; c < 3; ++c) {
        if (abs(chroma[c]) > abs(room[c])) {
            keep = min(keep, room[c] / chroma[c]);
        }
    }
    return clamp(grey + keep * chroma, 0.0, 1.0);
}

vec3 srgbCurve(vec3 linear) {
    vec3 low = 12.92 * linear;
    vec3 high = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

vec3 displayColor(vec3 xyz, float exposure) {
    vec3 exposed = exposure * xyz;
    return srgbCurve(intoGamut(xyzToLinearSrgb(exposed), exposed.y));
}
