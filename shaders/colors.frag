#version 330 core
#include "method/{METHOD}.glsl"
#include "include/loops.glsl"

// Colors of a list of (u, v, w), one a fragment: what tables of colors are made of.

// (u, v, w) of each fragment, from double precision, and 1; 0 where nothing is asked for.
uniform sampler2D places;

// CIE XYZ of power.
layout(location = 0) out vec4 color;

void main() {
    vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0);
    if (place.w == 0.0) {
        color = vec4(0.0);
        return;
    }
    color = vec4(diffractedXyz(place.xyz), 1.0);
    if (loopsWereCut()) {
        color = vec4(LOOPS_CUT);
    }
}
