// Directions in the tangent frame: x tangent, y bitangent, z normal. wi points to the light, wr to the viewer.

// (u, v, w) of the diffraction integral (Stam 1999, section 4); w is never positive.
vec3 diffractionVector(vec3 wi, vec3 wr) {
    return -(wi + wr);
}

// Cosine of the angle between the half vector and either direction, sqrt((1 + wi . wr) / 2), for unit vectors. If light and viewer are
// nearly opposite to each other, their sum keeps digits that 1 + wi . wr loses.
float halfAngleCosine(vec3 wi, vec3 wr) {
    return 0.5 * length(wi + wr);
}
