#include "include/constants.glsl"

// Real coefficients c_n(zeta) of exp(-i zeta s) = sum (-i)^turns(n) c_n T_n(s), one after the other; zeta = k |w|
// halfRange. The constant quarter turns are in the tables of T_n already.

// EXPANSION: EXPANSION_TAYLOR or EXPANSION_SAMPLED; TERMS: the number of terms.

// Half of the relief in meters; heights are divided by it, to [-1, 1].
uniform float heightHalfRange;

float expansionPhase(float w, float wavelength) {
    return 2.0 * PI * abs(w) * heightHalfRange / wavelength;
}

// Coefficients of the expansion from a table: phases along x, a row of texels per four.

// The sample nearest to a phase, and the weights of the one before it, its own and of the one behind it in the parabola
// through the three.
struct PhaseSamples {
    int middle;
    vec3 weights;
};

// phaseMap: offset and scale from zeta to the place among the samples.
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

// One row of texels per term: each sample between the ones before and behind it.
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
