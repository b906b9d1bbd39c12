#version 330 core
#define NEAREST_FINER_LEVEL
#include "include/relief.glsl"
#include "include/packed_surface.glsl"

// What geometry.frag notes of a skin, as far as moving pictures need it and in a fourth of the memory: what is left out, the direction
// to the viewer, follows from the pixel's place (jrtr/view_rays.glsl), and where it lies from its depth. Textures are as fine as in the
// samples of a final picture, two along a pixel's side.

// Linear light; the sampler undoes the sRGB curve.
uniform sampler2D bodyTexture;

layout(location = 0) out vec4 surface;

void main() {
    vec4 relief = reliefTexel();
    vec3 albedo = relief.w * texelAt(bodyTexture, surfaceCoordinate).rgb;
    surface = packedSkin(reliefNormal(relief.xy), worldTangent, patchTurn(), albedo, abs(worldTangent.w));
}
