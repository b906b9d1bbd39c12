#version 330 core
#include "jrtr/surface.glsl"

// Depths as the light sees them: what is cleared to 0 is as far as can be.
layout(location = 0) out vec4 nearness;

void main() {
    nearness = vec4(1.0 - gl_FragCoord.z);
}
