#include "include/average.glsl"

// Sum over fixed wavelengths, equal for all directions, with exact CIE weights.

// One texel per wavelength: the wavelength in meters and the weights of X, Y and Z. The weights' sums over all wavelengths are the white of
// D65.
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
