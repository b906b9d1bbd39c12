// Coefficients c_n(zeta) of exp(-i zeta s) = sum c_n T_n(s), one after the other, zeta = k |w| halfRange.

// Half of the relief, metres, by which heights were scaled to [-1, 1].
uniform float heightHalfRange;

float expansionPhase(float w, float wavelength) {
    const float TWO_PI = 6.283185307;
    return TWO_PI * abs(w) * heightHalfRange / wavelength;
}

#if EXPANSION == EXPANSION_TAYLOR

// c_n = (-i zeta)^n / n! (thesis eq. 2.44): each is the one before times -i zeta / n.
vec2 firstCoefficient(float zeta) {
    return vec2(1.0, 0.0);
}

vec2 nextCoefficient(vec2 previous, int n, float zeta) {
    return vec2(previous.y, -previous.x) * (zeta / float(n));
}

#else

// Sampled coefficients: one row of texels per term, one column per phase.
uniform sampler2D expansionCoefficients;
// Maps zeta to the texture coordinate of its column: offset, scale.
uniform vec2 expansionPhaseMap;

vec2 nextCoefficient(vec2 previous, int n, float zeta) {
    vec2 at = vec2(expansionPhaseMap.x + expansionPhaseMap.y * zeta, (float(n) + 0.5) / float(TERMS));
    return texture(expansionCoefficients, at).rg;
}

vec2 firstCoefficient(float zeta) {
    return nextCoefficient(vec2(0.0), 0, zeta);
}

#endif
