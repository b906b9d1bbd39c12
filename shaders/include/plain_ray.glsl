#include "include/average.glsl"

// A ray of which nothing is worked out before the wavelengths: each step asks for the power in that direction.

struct Ray {
    vec3 uvw;
};

#include "include/integral.glsl"

float powerAtStep(Ray ray, int step, float wavelength) {
    return averagePower(ray.uvw, wavelength);
}
