#include "include/row.glsl"

// CIE 1931 color matching functions times D65 at any wavelength, normalized so that their integral over wavelength is the
// white of D65 with Y = 1.

// Eight texels per nanometer from 380 to 780 nm (sunbeam.precompute.plan.ShaderArrays): row SMOOTH_WEIGHTS is smoothed, row TABLE_WEIGHTS
// interpolates the CIE's tables linearly, with corners at whole nanometers.
uniform sampler2D cieWeights;

const float SHORTEST_WAVELENGTH = 380e-9;
const float LONGEST_WAVELENGTH = 780e-9;

const int SMOOTH_WEIGHTS = 0;
const int TABLE_WEIGHTS = 1;

// Weights of X, Y, Z per meter of wavelength.
vec3 cieWeight(float wavelength, int weights) {
    return betweenTexels(cieWeights, (wavelength - SHORTEST_WAVELENGTH) * 8e9, weights).rgb;
}

// XYZ of the power 1 at all wavelengths: the white of D65 over 380 to 780 nm.
uniform vec3 cieWhite;
