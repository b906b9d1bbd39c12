#version 330 core
#define NEAREST_FINER_LEVEL
#include "include/relief.glsl"
#include "include/packed_surface.glsl"

// Geometry pass of moving pictures (include/packed_surface.glsl). moving.frag derives the view direction from the pixel
// (jrtr/view_rays.glsl) and the position from its depth. Mip levels are those of a final picture with two samples along a pixel's side.

// Linear light; the sampler undoes the sRGB curve.
uniform sampler2D bodyTexture;

layout(location = 0) out vec4 surface;

void main() {
    vec4 relief = reliefTexel();
    vec3 albedo = relief.w * texelAt(bodyTexture, surfaceCoordinate).rgb;
    surface = packedSkin(reliefNormal(relief.xy), worldTangent, patchTurn(), albedo, abs(worldTangent.w));
}
