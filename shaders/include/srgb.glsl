// Linear XYZ and sRGB (IEC 61966-2-1): primaries with the white of D65, and the curve.

const mat3 LINEAR_SRGB_TO_XYZ = mat3(
        0.4124564, 0.2126729, 0.0193339,
        0.3575761, 0.7151522, 0.1191920,
        0.1804375, 0.0721750, 0.9503041);

const mat3 XYZ_TO_LINEAR_SRGB = mat3(
        3.2404542, -0.9692660, 0.0556434,
        -1.5371385, 1.8760108, -0.2040259,
        -0.4985314, 0.0415560, 1.0572252);

vec3 srgbCurve(vec3 linear) {
    vec3 low = 12.92 * linear;
    vec3 high = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

// Approximation of srgbCurve on [0, 1] with an error below 0.01 / 255, fitted for the least maximal error. It needs square roots instead of
// powers, which is faster, for pictures drawn while something moves.
vec3 srgbCurveByRoots(vec3 linear) {
    vec3 low = 12.92 * linear;
    vec3 second = sqrt(max(linear, vec3(0.0031308)));
    vec3 fourth = sqrt(second);
    vec3 high = 0.65400592 * second + 0.68866759 * fourth - 0.31843678 * sqrt(fourth) - 0.02019219 * linear - 0.00407596;
    return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}
