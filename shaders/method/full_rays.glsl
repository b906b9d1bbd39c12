#include "include/plain_ray.glsl"
#include "method/neighbourhood.glsl"

// Neighbourhoods of bins at wavelengths in equal steps along the ray f = (u, v) / lambda.

// Distance of wavelengths along the ray, cycles per metre.
uniform float rayNodeStep;
// Wavelengths of directions near the specular one, whose ray is short.
uniform int rayFewestNodes;

vec3 diffractedXyz(vec3 uvw) {
    float band = 1.0 / SHORTEST_WAVELENGTH - 1.0 / LONGEST_WAVELENGTH;
    int along = int(ceil(length(uvw.xy) * band / rayNodeStep)) + 1;
    return bandXyz(Ray(uvw), cutBand(max(rayFewestNodes, along)));
}
