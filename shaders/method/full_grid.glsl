// Windowed spectra on a grid, interpolated. A direction sees the ray f = (u, v) / lambda; its wavelengths are placed where
// the ray crosses the grid's columns (rows, where |v| > |u|), so that only one axis is left to interpolate.

// Distance of columns, cycles per metre.
uniform float gridNodeStep;
// Samples per cycle per metre along a column.
uniform float gridRayScale;
// Index of the first column and of the first sample on it: x, y for columns along x; z, w for rows along y.
uniform vec4 gridRaysFirst;
// Largest of |u|, |v| whose ray crosses too few columns, and the number of wavelengths it takes instead.
uniform float gridCentreReach;
uniform int gridCentreNodes;
// A ray that crosses enough columns stops at every second one, or third, up to this.
uniform int gridLargestStride;

float pointPower(vec3 uvw, float wavelength) {
    float zeta = expansionPhase(uvw.z, wavelength);
#if AVERAGE == AVERAGE_ENSEMBLE
    return ensemblePointPower(uvw.xy / wavelength, zeta);
#else
    return coherentPointPower(uvw.xy / wavelength, zeta);
#endif
}

#ifdef SPECTRAL
float coherentPower(vec3 uvw, float wavelength) {
    return coherentPointPower(uvw.xy / wavelength, expansionPhase(uvw.z, wavelength));
}

float ensemblePower(vec3 uvw, float wavelength) {
    return ensemblePointPower(uvw.xy / wavelength, expansionPhase(uvw.z, wavelength));
}
#else

// Near the specular direction: equal steps of 1 / lambda, both axes interpolated.
vec3 centreXyz(vec3 uvw) {
    float first = 1.0 / LONGEST_WAVELENGTH;
    float stepSize = (1.0 / SHORTEST_WAVELENGTH - first) / float(gridCentreNodes - 1);
    vec3 sum = vec3(0.0);
    vec3 weights = vec3(0.0);
    for (int i = 0; i < gridCentreNodes; ++i) {
        float wavelength = 1.0 / (first + stepSize * float(i));
        vec3 weight = cieWeight(wavelength) * (wavelength * wavelength);
        sum += weight * pointPower(uvw, wavelength);
        weights += weight;
    }
    // Constant power comes out exactly, however few the wavelengths.
    return sum * cieWhite / weights;
}

vec3 diffractedXyz(vec3 uvw) {
    bool alongX = abs(uvw.x) >= abs(uvw.y);
    float major = alongX ? uvw.x : uvw.y;
    if (abs(major) < gridCentreReach) {
        return centreXyz(uvw);
    }
    float minorPerColumn = (alongX ? uvw.y : uvw.x) / abs(major) * gridNodeStep * gridRayScale;
    float direction = sign(major);
    vec2 origin = alongX ? gridRaysFirst.xy : gridRaysFirst.zw;
#if AVERAGE == AVERAGE_ENSEMBLE
    int firstLayer = alongX ? 0 : ENSEMBLE_LAYERS;
#else
    int firstLayer = alongX ? 0 : COHERENT_LAYERS;
#endif
    // 1 / lambda = column step / |major|, and the phase grows in proportion.
    float crossed = abs(major) / gridNodeStep * (1.0 / SHORTEST_WAVELENGTH - 1.0 / LONGEST_WAVELENGTH);
    int stride = clamp(int(crossed) / gridCentreNodes, 1, gridLargestStride);
    float waveNumberStep = gridNodeStep * float(stride) / abs(major);
    float zetaStep = expansionPhase(uvw.z, 1.0) * waveNumberStep;
    int first = int(ceil(1.0 / (LONGEST_WAVELENGTH * waveNumberStep)));
    int last = int(floor(1.0 / (SHORTEST_WAVELENGTH * waveNumberStep)));
    vec3 sum = vec3(0.0);
    vec3 weights = vec3(0.0);
    for (int m = first; m <= last; ++m) {
        float count = float(m * stride);
        float wavelength = 1.0 / (float(m) * waveNumberStep);
        // d lambda = lambda^2 d(1 / lambda), with equal steps of 1 / lambda.
        vec3 weight = cieWeight(wavelength) * (wavelength * wavelength);
        int column = int(direction * count - origin.x);
        Taps taps = tapsAround(count * minorPerColumn - origin.y);
#if AVERAGE == AVERAGE_ENSEMBLE
        float power = ensembleRayPower(firstLayer, column, taps, float(m) * zetaStep);
#else
        float power = coherentRayPower(firstLayer, column, taps, float(m) * zetaStep);
#endif
        sum += weight * power;
        weights += weight;
    }
    return sum * cieWhite / weights;
}
#endif
