#include "include/constants.glsl"

// Real coefficients c_n(zeta) of the expansion exp(-i zeta s) = sum (-i)^turns(n) c_n T_n(s), computed one after the other. zeta = 2 pi |w|
// heightHalfRange / lambda is the phase of the largest height, s in [-1, 1] a height. The tables of T_n include the constant factors
// (-i)^turns(n), turns(n) quarter turns.

// EXPANSION: EXPANSION_TAYLOR or EXPANSION_SAMPLED; TERMS: the number of terms.

// Half of the difference between largest and least height in meters; heights divided by it are in [-1, 1].
uniform float heightHalfRange;

float expansionPhase(float w, float wavelength) {
    return 2.0 * PI * abs(w) * heightHalfRange / wavelength;
}

// Coefficients from a table: columns are samples of zeta, a row of texels has four coefficients.

// The sample nearest to a phase, and the weights in the parabola through three samples: of the one before, of the nearest, of the one
// after.
struct PhaseSamples {
    int middle;
    vec3 weights;
};

// phaseMap: offset and scale from zeta to the position among the samples, 0 at the first.
PhaseSamples samplesAround(sampler2D table, vec2 phaseMap, float zeta) {
    float place = phaseMap.x + phaseMap.y * zeta;
    int middle = clamp(int(floor(place + 0.5)), 1, textureSize(table, 0).x - 2);
    float t = place - float(middle);
    float halfPlace = 0.5 * t;
    return PhaseSamples(middle, vec3(halfPlace * t - halfPlace, 1.0 - t * t, halfPlace * t + halfPlace));
}

vec4 sampledCoefficients(sampler2D table, PhaseSamples samples, int row) {
    return samples.weights.x * texelFetch(table, ivec2(samples.middle - 1, row), 0)
            + samples.weights.y * texelFetch(table, ivec2(samples.middle, row), 0)
            + samples.weights.z * texelFetch(table, ivec2(samples.middle + 1, row), 0);
}

#if EXPANSION == EXPANSION_TAYLOR

// c_n = zeta^n / n! (thesis eq. 2.44): each is the previous one times zeta / n.
float firstCoefficient(float zeta) {
    return 1.0;
}

float nextCoefficient(float previous, int n, float zeta) {
    return previous * (zeta / float(n));
}

#else

// One row of texels per term: a texel has the sample before, the sample itself and the one after.
uniform sampler2D expansionCoefficients;
uniform vec2 expansionPhaseMap;

float nextCoefficient(float previous, int n, float zeta) {
    PhaseSamples samples = samplesAround(expansionCoefficients, expansionPhaseMap, zeta);
    return dot(samples.weights, texelFetch(expansionCoefficients, ivec2(samples.middle, n), 0).xyz);
}

float firstCoefficient(float zeta) {
    return nextCoefficient(0.0, 0, zeta);
}

#endif
