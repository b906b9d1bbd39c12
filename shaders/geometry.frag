#version 330 core
#include "include/relief.glsl"
#include "include/patch_map.glsl"

// Geometry pass: surface attributes of each pixel, independent of the light. The costly shading pass (skin.frag) then runs once per pixel
// instead of once per triangle and 2 x 2 block. If only light or blend weights change, only the shading pass runs again.

uniform sampler2D bodyTexture;
// Number of the object's first patch, from 1 (sunbeam.app.render.SceneData).
uniform float firstPatch;

const float BARE = 0.5;

// Unit vector towards the viewer, tangent frame; w is the patch's number, plus BARE without nanostructure; 0 where nothing is drawn.
layout(location = 0) out vec4 view;
// Unit normal with the relief, world space; w is the tangent frame's handedness, 1 or -1.
layout(location = 1) out vec4 normal;
// Unit vector along the patch's x axis, world space; w is the visible share of the sky.
layout(location = 2) out vec4 tangent;
// Color of the body, linear sRGB.
layout(location = 3) out vec4 albedo;

void main() {
    vec4 relief = reliefTexel();
    vec4 body = texture(bodyTexture, surfaceCoordinate);
    mat3 frame = tangentFrameAbout(reliefNormal(relief.xy), patchTurn());
    view = vec4(viewDirection(frame), firstPatch + patchHere() + (body.a < 0.5 ? BARE : 0.0));
    normal = vec4(frame[2], frameHandedness());
    tangent = vec4(frame[0], visibleSky());
    albedo = vec4(skinAlbedo(relief, body.rgb), 1.0);
}
