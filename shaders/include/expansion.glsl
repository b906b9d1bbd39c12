#include "include/constants.glsl"

// Real coefficients c_n(zeta) of exp(-i zeta s) = sum (-i)^turns(n) c_n T_n(s), one after the other; zeta = k |w|
// halfRange. The constant quarter turns are in the tables of T_n already.

// EXPANSION: EXPANSION_TAYLOR or EXPANSION_SAMPLED; TERMS: the number of terms.

// Half of the relief, metres, by which heights were scaled to [-1, 1].
uniform float heightHalfRange;

float expansionPhase(float w, float wavelength) {
    return 2.0 * PI * abs(w) * heightHalfRange / wavelength;
}

// Coefficients of the expansion from a table: phases along x, a row of texels per coefficient, or per four. Where a row is too
// short for all phases, each goes on in pieces below it, which share three samples with the one before.

// Four samples of one piece, side by side, and their weights in the cubic through them.
struct PhaseSamples {
    int first;
    int piece;
    int pieces;
    vec4 weights;
};

// phaseMap: offset and scale from zeta to the place among all samples; rows: of coefficients in the table.
PhaseSamples samplesAround(sampler2D table, vec2 phaseMap, float zeta, int rows) {
    ivec2 size = textureSize(table, 0);
    int pieces = size.y / rows;
    int stride = size.x - 3;
    float place = phaseMap.x + phaseMap.y * zeta;
    int first = clamp(int(floor(place)) - 1, 0, pieces * stride - 1);
    int piece = pieces == 1 ? 0 : first / stride;
    float a = place - float(first);
    float b = a - 1.0;
    float c = a - 2.0;
    float d = a - 3.0;
    vec4 weights = vec4(b * c * d / -6.0, a * c * d / 2.0, a * b * d / -2.0, a * b * c / 6.0);
    return PhaseSamples(first - piece * stride, piece, pieces, weights);
}

vec4 sampledCoefficients(sampler2D table, PhaseSamples samples, int row) {
    int y = row * samples.pieces + samples.piece;
    return samples.weights.x * texelFetch(table, ivec2(samples.first, y), 0)
            + samples.weights.y * texelFetch(table, ivec2(samples.first + 1, y), 0)
            + samples.weights.z * texelFetch(table, ivec2(samples.first + 2, y), 0)
            + samples.weights.w * texelFetch(table, ivec2(samples.first + 3, y), 0);
}

#if EXPANSION == EXPANSION_TAYLOR

// c_n = zeta^n / n! (thesis eq. 2.44): each is the one before times zeta / n.
float firstCoefficient(float zeta) {
    return 1.0;
}

float nextCoefficient(float previous, int n, float zeta) {
    return previous * (zeta / float(n));
}

#else

// One row of texels per term.
uniform sampler2D expansionCoefficients;
uniform vec2 expansionPhaseMap;

float nextCoefficient(float previous, int n, float zeta) {
    return sampledCoefficients(
                   expansionCoefficients, samplesAround(expansionCoefficients, expansionPhaseMap, zeta, TERMS), n)
            .r;
}

float firstCoefficient(float zeta) {
    return nextCoefficient(0.0, 0, zeta);
}

#endif
