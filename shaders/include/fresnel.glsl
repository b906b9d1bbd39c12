// Schlick's approximation of Fresnel's reflectance (Schlick 1994), R0 + (1 - R0) s with s = (1 - cos theta_d)^5.

// Along the normal: ((n - 1) / (n + 1))^2 for keratin, n = 1.5 (thesis section 2.5). The thesis's gain has the square of it all.
const float KERATIN_REFLECTANCE = 0.04;
#ifdef FRESNEL_SQUARED
const float NORMAL_REFLECTANCE = KERATIN_REFLECTANCE * KERATIN_REFLECTANCE;
#else
const float NORMAL_REFLECTANCE = KERATIN_REFLECTANCE;
#endif

// Over that of a flat mirror of the same material seen along the normal: mirrorWeight + grazingWeight s, 1 and (1 - R0) / R0.
// An index by wavelength has its R0 in the light's spectrum and other weights (app/render/ReflectanceComponent.java).
uniform float mirrorWeight = 1.0;
uniform float grazingWeight = 24.0;

// 0 to 1, of keratin.
float schlickReflectance(float cosThetaD) {
    float grazing = max(0.0, 1.0 - cosThetaD);
    float square = grazing * grazing;
    return KERATIN_REFLECTANCE + (1.0 - KERATIN_REFLECTANCE) * square * square * grazing;
}

float relativeReflectance(float cosThetaD) {
    // Rounding may push the cosine past 1.
    float grazing = max(0.0, 1.0 - cosThetaD);
    float square = grazing * grazing;
    float reflectance = mirrorWeight + grazingWeight * (square * square * grazing);
#ifdef FRESNEL_SQUARED
    reflectance *= reflectance;
#endif
    return reflectance;
}
