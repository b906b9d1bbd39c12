#version 330 core
#include "include/display.glsl"

// Exposure, gamut and the sRGB curve for a picture of linear XYZ.

uniform sampler2D linearPicture;
uniform float exposure;

// sRGB in [0, 1]; alpha as it comes.
layout(location = 0) out vec4 color;

void main() {
    vec4 linear = texelFetch(linearPicture, ivec2(gl_FragCoord.xy), 0);
    color = vec4(displayColor(linear.rgb, exposure), linear.a);
}
