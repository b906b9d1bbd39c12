// Schlick's approximation of Fresnel's reflectance (Schlick 1994).

// ((n - 1) / (n + 1))^2 for keratin, n = 1.5 (thesis section 2.5).
const float R0 = 0.04;

float reflectance(float cosThetaD) {
    // Rounding may push the cosine past 1, and pow() of a negative base is undefined.
    return R0 + (1.0 - R0) * pow(max(0.0, 1.0 - cosThetaD), 5.0);
}
