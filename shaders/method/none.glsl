#include "include/footprint.glsl"

// No diffraction: the body alone, for moving.frag before a scene's method is planned.

const float MISSING = 1e30;

vec3 levelXyz(Footprint footprint, float level) {
    return vec3(0.0);
}
