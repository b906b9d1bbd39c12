// Schlick's approximation of Fresnel's reflectance (Schlick 1994).

// Along the normal. Unless a scene says otherwise, ((n - 1) / (n + 1))^2 for keratin, n = 1.5 (thesis section 2.5).
uniform float normalReflectance = 0.04;

float reflectance(float cosThetaD) {
    // Rounding may push the cosine past 1, and pow() of a negative base is undefined.
    return normalReflectance + (1.0 - normalReflectance) * pow(max(0.0, 1.0 - cosThetaD), 5.0);
}
