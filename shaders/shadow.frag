#version 330 core
#include "jrtr/surface.glsl"

// What the light sees is its depth alone.
layout(location = 0) out vec4 nothing;

void main() {
    nothing = vec4(0.0);
}
