#include "include/average.glsl"

// Fixed wavelengths with their exact CIE weights, whatever the direction.

// One texel per node: wavelength in metres, weights of X, Y and Z, whose sums are the white of D65.
uniform sampler2D wavelengthNodes;
uniform int wavelengthCount;

vec3 fixedWavelengthsXyz(vec3 uvw) {
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < wavelengthCount; ++i) {
        vec4 node = texelFetch(wavelengthNodes, ivec2(i, 0), 0);
        xyz += node.yzw * averagePower(uvw, node.x);
    }
    return xyz;
}
