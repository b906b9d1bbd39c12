// For comparison only: an ideal grating of parallel lines, of which nothing but the spacing is known (Stam, "Simulating
// Diffraction", GPU Gems, 2004, chapter 8). Light leaves in direction u at all wavelengths spacing |u| / n; each order adds
// its rainbow colour. No surface, no efficiency of orders, no cut-off along the lines, no spectrum.

// Distance of the lines, which run along y, in metres.
uniform float gemSpacing;

// The chapter's choice.
const int GEM_ORDERS = 8;

float bump(float x) {
    return max(0.0, 1.0 - x * x);
}

// A rainbow from blue to red over the visible band as three bumps, linear sRGB; black outside.
vec3 rainbow(float wavelength) {
    float place = (wavelength - SHORTEST_WAVELENGTH) / (LONGEST_WAVELENGTH - SHORTEST_WAVELENGTH);
    return vec3(bump(4.0 * place - 3.0), bump(4.0 * place - 2.0), bump(4.0 * place - 1.0));
}

// There is no power without a surface. The application asks this method for colours only.
float coherentPower(vec3 uvw, float wavelength) {
    return 0.0;
}

float ensemblePower(vec3 uvw, float wavelength) {
    return 0.0;
}

vec3 diffractedXyz(vec3 uvw) {
    // Linear sRGB to XYZ (IEC 61966-2-1), columns of red, green, blue.
    const mat3 TO_XYZ = mat3(
            0.4124564, 0.2126729, 0.0193339,
            0.3575761, 0.7151522, 0.1191920,
            0.1804375, 0.0721750, 0.9503041);
    float path = gemSpacing * abs(uvw.x);
    // Order 0 has all wavelengths at once: white, as wide as half a wavelength of path difference.
    vec3 rgb = vec3(bump(path / (0.5 * SHORTEST_WAVELENGTH)));
    for (int n = 1; n <= GEM_ORDERS; ++n) {
        rgb += rainbow(path / float(n));
    }
    return TO_XYZ * rgb;
}
