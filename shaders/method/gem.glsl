#include "include/spectrum.glsl"
#include "include/srgb.glsl"

// An ideal grating of parallel lines, defined by the spacing of the lines alone, for comparison (Stam, "Simulating Diffraction", GPU Gems,
// 2004, chapter 8). Order n has the wavelength spacing |u| / n; each order adds that wavelength's rainbow color. The method ignores the
// surface's shape, the orders' efficiency, the directions along the lines and the light's spectrum.

// GEM_ORDERS: orders on each side. THESIS_FORM: 1 for the form of the thesis's program, 0 for Stam's.

// Distance between the lines, which run along y, in meters.
uniform float gemSpacing;

float bump(float x) {
    return max(0.0, 1.0 - x * x);
}

// A rainbow from blue to red over the visible band as three bumps, linear sRGB; black outside.
vec3 rainbow(float wavelength) {
    float place = (wavelength - SHORTEST_WAVELENGTH) / (LONGEST_WAVELENGTH - SHORTEST_WAVELENGTH);
    return vec3(bump(4.0 * place - 3.0), bump(4.0 * place - 2.0), bump(4.0 * place - 1.0));
}

vec3 ordersColor(float path) {
    vec3 color = vec3(0.0);
    for (int n = 1; n <= GEM_ORDERS; ++n) {
        color += rainbow(path / float(n));
    }
    return color;
}

// Thesis's form for maps: a line of 0.02 along the grating with a white disc in the mirror direction. The three bumps count as XYZ relative
// to white, a tenth as bright as the disc. The program multiplies values behind the display's curve by exp(-(1.5 u / w)^2), whose
// exponent 2.4 moves that factor before the curve.
vec3 thesisXyz(vec3 uvw) {
    const float HALF_WIDTH = 0.01;
    float slope = 1.5 * uvw.x / min(uvw.z, -1e-6);
    vec3 color = (abs(uvw.y) < HALF_WIDTH ? 0.1 : 0.0) * ordersColor(gemSpacing * abs(uvw.x));
    color += length(uvw.xy) < HALF_WIDTH ? 1.0 : 0.0;
    return exp(-2.4 * slope * slope) * (LINEAR_SRGB_TO_XYZ * vec3(1.0)) * color;
}

// No power at a single wavelength: this method has no surface.
vec3 diffractedXyz(vec3 uvw) {
    if (THESIS_FORM == 1) {
        return thesisXyz(uvw);
    }
    float path = gemSpacing * abs(uvw.x);
    // Order 0 has all wavelengths and is white; it fades out at half a wavelength of path difference.
    return LINEAR_SRGB_TO_XYZ * (vec3(bump(path / (0.5 * SHORTEST_WAVELENGTH))) + ordersColor(path));
}
