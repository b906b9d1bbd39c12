#version 330 core
#include "include/loops.glsl"
#include "method/{METHOD}.glsl"

// Colours of a list of (u, v, w), one a fragment: what tables of colours are made of.

// (u, v, w) of each fragment, from double precision.
uniform sampler2D places;

// CIE XYZ of power.
layout(location = 0) out vec4 colour;

void main() {
    colour = vec4(diffractedXyz(texelFetch(places, ivec2(gl_FragCoord.xy), 0).xyz), 1.0);
    if (loopsWereCut()) {
        colour = vec4(LOOPS_CUT);
    }
}
