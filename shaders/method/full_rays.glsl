#include "include/plain_ray.glsl"
#include "method/neighbourhood.glsl"

// Neighbourhoods of bins at wavelengths along the ray f = (u, v) / lambda.

// Largest panel of Gauss's rule along the ray, cycles per metre, and in 1 / lambda, where the ray is short.
uniform float rayPanel;
uniform float rayLargestPanel;

vec3 diffractedXyz(vec3 uvw) {
    return bandXyz(Ray(uvw), bandPanels(min(rayLargestPanel, rayPanel / length(uvw.xy))));
}
