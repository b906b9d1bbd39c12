#include "include/spectrum.glsl"
#include "include/srgb.glsl"

// For comparison only: an ideal grating of parallel lines, defined by its spacing alone (Stam, "Simulating
// Diffraction", GPU Gems, 2004, chapter 8). Light leaves in direction u at all wavelengths spacing |u| / n; each order adds
// its rainbow color. No surface, no efficiency of orders, no cut-off along the lines, no spectrum.

// GEM_ORDERS: orders on each side.

// Distance of the lines, which run along y, in meters.
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
    // Order 0 has all wavelengths at once: white, as wide as half a wavelength of path difference.
    vec3 rgb = vec3(bump(path / (0.5 * SHORTEST_WAVELENGTH)));
    for (int n = 1; n <= GEM_ORDERS; ++n) {
        rgb += rainbow(path / float(n));
    }
    return LINEAR_SRGB_TO_XYZ * rgb;
}
