#version 330 core
#include "include/srgb.glsl"

// Adds a picture to a sum of linear light, or shows the sum's mean over its samples.

uniform sampler2D picture;
// Number of samples in the sum; 0 to add.
uniform float sampleCount;

layout(location = 0) out vec4 color;

void main() {
    vec3 seen = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 linear = mix(pow((seen + 0.055) / 1.055, vec3(2.4)), seen / 12.92, lessThanEqual(seen, vec3(0.04045)));
    color = vec4(sampleCount == 0.0 ? linear : srgbCurve(seen / max(sampleCount, 1.0)), 1.0);
}
