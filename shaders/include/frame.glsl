// Directions in the tangent frame: x tangent, y bitangent, z normal. wi points to the light, wr to the viewer.

// (u, v, w) of the diffraction integral (Stam 1999, section 4); w is never positive.
vec3 diffractionVector(vec3 wi, vec3 wr) {
    return -(wi + wr);
}

// Cosine of the angle between the half vector and either direction.
float halfAngleCosine(vec3 wi, vec3 wr) {
    return sqrt(max(0.0, 0.5 * (1.0 + dot(wi, wr))));
}
