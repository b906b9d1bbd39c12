// Octahedral encoding of a direction, of any length, as a point of [-1, 1]^2 (Meyer et al. 2010), and its inverse, whose result is not
// normalized.

float signOf(float x) {
    return x < 0.0 ? -1.0 : 1.0;
}

vec2 onOctahedron(vec3 direction) {
    vec3 on = direction / max(abs(direction.x) + abs(direction.y) + abs(direction.z), 1e-30);
    vec2 folded = (1.0 - abs(on.yx)) * vec2(signOf(on.x), signOf(on.y));
    return on.z < 0.0 ? folded : on.xy;
}

vec3 fromOctahedron(vec2 square) {
    float z = 1.0 - abs(square.x) - abs(square.y);
    vec2 folded = (1.0 - abs(square.yx)) * vec2(signOf(square.x), signOf(square.y));
    return vec3(z < 0.0 ? folded : square, z);
}
