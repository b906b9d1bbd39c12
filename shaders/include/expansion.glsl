#include "include/constants.glsl"
#include "include/row.glsl"

// Real coefficients c_n(zeta) of exp(-i zeta s) = sum (-i)^turns(n) c_n T_n(s), one after the other; zeta = k |w|
// halfRange. The constant quarter turns are in the tables of T_n already.

// EXPANSION: EXPANSION_TAYLOR or EXPANSION_SAMPLED; TERMS: the number of terms.

// Half of the relief, metres, by which heights were scaled to [-1, 1].
uniform float heightHalfRange;

float expansionPhase(float w, float wavelength) {
    return 2.0 * PI * abs(w) * heightHalfRange / wavelength;
}

// Coefficients of the expansion from a table: phases along x, a row of texels per coefficient, or per four. phaseMap: offset
// and scale from zeta to the place in texels.
vec4 sampledCoefficients(sampler2D table, vec2 phaseMap, float zeta, int row, int rows) {
    return betweenTexels(table, phaseMap.x + phaseMap.y * zeta, row);
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
    return sampledCoefficients(expansionCoefficients, expansionPhaseMap, zeta, n, TERMS).r;
}

float firstCoefficient(float zeta) {
    return nextCoefficient(0.0, 0, zeta);
}

#endif
