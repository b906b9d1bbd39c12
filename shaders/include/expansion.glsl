// Real coefficients c_n(zeta) of exp(-i zeta s) = sum (-i)^turns(n) c_n T_n(s), one after the other; zeta = k |w|
// halfRange. The constant quarter turns are in the tables of T_n already.

// Half of the relief, metres, by which heights were scaled to [-1, 1].
uniform float heightHalfRange;

float expansionPhase(float w, float wavelength) {
    const float TWO_PI = 6.283185307;
    return TWO_PI * abs(w) * heightHalfRange / wavelength;
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

// Sampled coefficients: one row of texels per term, one column per phase.
uniform sampler2D expansionCoefficients;
// Maps zeta to the texture coordinate of its column: offset, scale.
uniform vec2 expansionPhaseMap;

float nextCoefficient(float previous, int n, float zeta) {
    vec2 at = vec2(expansionPhaseMap.x + expansionPhaseMap.y * zeta, (float(n) + 0.5) / float(TERMS));
    return texture(expansionCoefficients, at).r;
}

float firstCoefficient(float zeta) {
    return nextCoefficient(0.0, 0, zeta);
}

#endif
