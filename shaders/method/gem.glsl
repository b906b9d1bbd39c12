#include "include/spectrum.glsl"
#include "include/srgb.glsl"

// An ideal grating of parallel lines, defined by the spacing of the lines alone, for comparison (Stam, "Simulating Diffraction", GPU Gems,
// 2004, chapter 8). Order n has the wavelength spacing |u| / n; each order adds that wavelength's rainbow color. The method ignores the
// surface's shape, the orders' efficiency, the directions along the lines and the light's spectrum.

// GEM_ORDERS: orders on each side.

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

// No power at a single wavelength: this method has no surface.
vec3 diffractedXyz(vec3 uvw) {
    float path = gemSpacing * abs(uvw.x);
    // Order 0 has all wavelengths and is white; it fades out at half a wavelength of path difference.
    vec3 rgb = vec3(bump(path / (0.5 * SHORTEST_WAVELENGTH)));
    for (int n = 1; n <= GEM_ORDERS; ++n) {
        rgb += rainbow(path / float(n));
    }
    return LINEAR_SRGB_TO_XYZ * rgb;
}
