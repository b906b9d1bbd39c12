// Complex numbers as (real, imaginary).

float squaredMagnitude(vec2 a) {
    return dot(a, a);
}
