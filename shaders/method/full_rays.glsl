#include "include/plain_ray.glsl"
#include "method/neighbourhood.glsl"

// Neighbourhoods of bins at wavelengths along the ray f = (u, v) / lambda.

vec3 diffractedXyz(vec3 uvw) {
    return cutBandXyz(Ray(uvw), length(uvw.xy));
}
