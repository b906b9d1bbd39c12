#version 330 core
#define SHADOW_TAPS 16
#include "include/relief.glsl"
#include "include/patch_map.glsl"
#include "include/shadow.glsl"

// What of a skin each pixel shows, whatever the light: the costly shader after this one (skin.frag) then runs once per
// pixel, not once per triangle's block of pixels, and again only for light and weights that change.

// Linear light; the sampler undoes the sRGB curve.
uniform sampler2D bodyTexture;

// Towards the viewer, tangent frame; w is 2 where this patch is, 1 where another is, so that covered pixels are known.
layout(location = 0) out vec4 view;
// Unit vector, world space; w is the frame's handedness, 1 or -1.
layout(location = 1) out vec4 normal;
// Unit vector, world space, turned as the patch is; w is how much of the sky is seen.
layout(location = 2) out vec4 tangent;
// The texture, linear sRGB; alpha is how much of the first light arrives.
layout(location = 3) out vec4 albedo;

void main() {
    vec4 relief = reliefTexel();
    mat3 frame = tangentFrameAbout(reliefNormal(relief.xy), patchTurn());
    view = vec4(viewDirection(frame), patchColorHere() == patchColor ? 2.0 : 1.0);
    normal = vec4(frame[2], frameHandedness());
    tangent = vec4(frame[0], min(abs(worldTangent.w), 1.0));
    albedo = vec4(relief.w * texture(bodyTexture, surfaceCoordinate).rgb, litShare(worldPosition, normalize(worldNormal)));
}
