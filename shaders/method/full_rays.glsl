// Neighbourhoods of bins at wavelengths in equal steps along the ray f = (u, v) / lambda.

// Distance of wavelengths along the ray, cycles per metre.
uniform float rayNodeStep;
// Wavelengths of directions near the specular one, whose ray is short.
uniform int rayFewestNodes;

vec3 diffractedXyz(vec3 uvw) {
    float first = 1.0 / LONGEST_WAVELENGTH;
    float band = 1.0 / SHORTEST_WAVELENGTH - first;
    int nodes = max(rayFewestNodes, int(ceil(length(uvw.xy) * band / rayNodeStep)) + 1);
    float stepSize = band / float(nodes - 1);
    vec3 sum = vec3(0.0);
    vec3 weights = vec3(0.0);
    for (int i = 0; i < nodes; ++i) {
        float wavelength = 1.0 / (first + stepSize * float(i));
        // d lambda = lambda^2 d(1 / lambda), with equal steps of 1 / lambda.
        vec3 weight = cieWeight(wavelength) * (wavelength * wavelength);
#if AVERAGE == AVERAGE_ENSEMBLE
        sum += weight * ensemblePower(uvw, wavelength);
#else
        sum += weight * coherentPower(uvw, wavelength);
#endif
        weights += weight;
    }
    // Constant power comes out exactly, however few the wavelengths.
    return sum * cieWhite / weights;
}
