#version 330 core
#include "jrtr/surface.glsl"

// Draws the depth map of a light, which needs no color.
layout(location = 0) out vec4 nothing;

void main() {
    nothing = vec4(0.0);
}
