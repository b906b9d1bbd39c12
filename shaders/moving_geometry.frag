#version 330 core
#define NEAREST_FINER_LEVEL
#include "include/relief.glsl"
#include "include/packed_surface.glsl"

// Geometry pass of pictures that are drawn while something in the viewer moves (include/packed_surface.glsl). moving.frag derives the view
// direction from the pixel (jrtr/view_rays.glsl) and the position from its depth. NEAREST_FINER_LEVEL (include/relief.glsl) selects the mip
// levels of a picture at rest, which has two samples along a pixel's side.

uniform sampler2D bodyTexture;

layout(location = 0) out vec4 surface;

void main() {
    vec4 relief = reliefTexel();
    vec4 body = texelAt(bodyTexture, surfaceCoordinate);
    vec3 albedo = skinAlbedo(relief, body.rgb);
    surface = packedSkin(reliefNormal(relief.xy), worldTangent, patchTurn(), albedo, visibleSky());
    // Without nanostructure.
    surface.w *= body.a < 0.5 ? -1.0 : 1.0;
}
