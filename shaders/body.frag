#version 330 core
#include "jrtr/lights.glsl"
#include "include/blend.glsl"
#include "include/geometry.glsl"

// A skin under its lights without diffraction, from what geometry.frag found in each pixel: the part of skin.frag's picture
// that is cheap, for previews that show it in a finer resolution.

// Linear XYZ; alpha 1, the skin's coverage.
layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(views, pixel, 0).w == 0.0) {
        discard;
    }
    vec3 normal = texelFetch(normals, pixel, 0).xyz;
    vec3 albedo = LINEAR_SRGB_TO_XYZ * texelFetch(albedos, pixel, 0).rgb;
    vec3 sum = vec3(0.0);
    for (int light = 0; light < lightCount; ++light) {
        sum += lightRadiances[light].y * bodyXyz(albedo, dot(lightDirections[light], normal));
    }
    radiance = vec4(sum, 1.0);
}
