// Complex numbers as (real, imaginary).

vec2 complexMultiply(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

float squaredMagnitude(vec2 a) {
    return dot(a, a);
}
