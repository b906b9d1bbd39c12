// Schlick's approximation of Fresnel's reflectance (Schlick 1994), R0 + (1 - R0) s with s = (1 - cos theta_d)^5.

// R0, the reflectance along the normal, ((n - 1) / (n + 1))^2 of keratin, n = 1.5 (thesis section 3.3.2). The thesis's gain has the square of
// the relative reflectance.
const float NORMAL_REFLECTANCE = 0.04;

// Weights of the relative reflectance, mirrorWeight + grazingWeight s: 1 and (1 - R0) / R0, so that it is 1 along the normal. For an index
// by wavelength R0 is a factor of the light's spectrum, and the weights differ (sunbeam.app.render.SceneData.ReflectanceComponent).
uniform float mirrorWeight = 1.0;
uniform float grazingWeight = 24.0;

// Reflectance of keratin, 0 to 1.
float schlickReflectance(float cosThetaD) {
    float grazing = max(0.0, 1.0 - cosThetaD);
    float square = grazing * grazing;
    return NORMAL_REFLECTANCE + (1.0 - NORMAL_REFLECTANCE) * square * square * grazing;
}

float relativeReflectance(float cosThetaD) {
    float grazing = max(0.0, 1.0 - cosThetaD);
    float square = grazing * grazing;
    float reflectance = mirrorWeight + grazingWeight * (square * square * grazing);
#ifdef FRESNEL_SQUARED
    reflectance *= reflectance;
#endif
    return reflectance;
}
