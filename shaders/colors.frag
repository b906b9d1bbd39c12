#version 330 core
#include "method/{METHOD}.glsl"
#include "include/loops.glsl"

// Colors at a list of (u, v, w), one per fragment: samples of color tables.

// One texel per fragment: (u, v, w), rounded from double precision, and 1; the fourth number is 0 where the fragment is unused.
uniform sampler2D samples;

// CIE XYZ of power.
layout(location = 0) out vec4 color;

void main() {
    vec4 place = texelFetch(samples, ivec2(gl_FragCoord.xy), 0);
    if (place.w == 0.0) {
        color = vec4(0.0);
        return;
    }
    color = vec4(diffractedXyz(place.xyz), 1.0);
    if (loopsWereCut()) {
        color = vec4(LOOPS_CUT);
    }
}
