#include "include/spectrum.glsl"
// Included only for its uniforms, which the application sets for both forms of nmm.
#include "include/wavelengths.glsl"
#include "method/nmm_bins.glsl"

// The thesis's own form of nmm (section 3.5): wavelengths L |u| / n and L |v| / n for a patch of side L, all with the
// weight of one step of wavelength. This treats all orders as equally wide. Blue orders are narrower and so get too much weight, which
// gives a purple cast.

// Weight of each wavelength: a step of wavelength in meters.
uniform float orderStep;

vec3 alongAxis(vec3 uvw, float bins) {
    vec3 xyz = vec3(0.0);
    int last = int(floor(bins / SHORTEST_WAVELENGTH));
    for (int n = max(1, int(ceil(bins / LONGEST_WAVELENGTH))); n <= last; ++n) {
        float wavelength = bins / float(n);
        xyz += cieWeight(wavelength, SMOOTH_WEIGHTS) * averagePower(uvw, wavelength);
    }
    return orderStep * xyz;
}

vec3 diffractedXyz(vec3 uvw) {
    vec2 bins = abs(uvw.xy) * tablePeriod;
    // Near u = v = 0 no wavelength meets a bin, and the thesis draws a white disc.
    if (length(bins) < SHORTEST_WAVELENGTH) {
        return cieWhite;
    }
    return alongAxis(uvw, bins.x) + alongAxis(uvw, bins.y);
}

#ifdef SPECTRAL
// Power at a wavelength: the orders along an axis whose wavelengths lie within half a step of it.
float powerAlongAxis(vec3 uvw, float bins, float wavelength) {
    float power = 0.0;
    int last = int(floor(bins / (wavelength - 0.5 * orderStep)));
    for (int n = max(1, int(ceil(bins / (wavelength + 0.5 * orderStep)))); n <= last; ++n) {
        power += coherentBinsPowerAt(uvw, bins / float(n));
    }
    return power;
}

float coherentPower(vec3 uvw, float wavelength) {
    vec2 bins = abs(uvw.xy) * tablePeriod;
    return powerAlongAxis(uvw, bins.x, wavelength) + powerAlongAxis(uvw, bins.y, wavelength);
}

float ensemblePower(vec3 uvw, float wavelength) {
    return ensembleBinsPower(uvw, wavelength);
}
#endif
