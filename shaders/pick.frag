#version 330 core
#include "include/relief.glsl"
#include "include/patch_map.glsl"

// Attributes of the point of a mesh under a pixel (sunbeam.app.render.Pick).

// Index of the object in the scene.
uniform float objectNumber;

// Position in meters, world space; w is one more than the patch's index in the object, 0 in the background. Then the tangent frame,
// world space; the tangent's w is the object's index.
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 tangent;
layout(location = 2) out vec4 bitangent;
layout(location = 3) out vec4 normal;
// Unit vectors in the tangent frame: towards the first light and the viewer.
layout(location = 4) out vec4 light;
layout(location = 5) out vec4 view;

void main() {
    mat3 frame = tangentFrameAbout(reliefNormal(reliefTexel().xy), patchTurn());
    position = vec4(worldPosition, 1.0 + patchHere());
    tangent = vec4(frame[0], objectNumber);
    bitangent = vec4(frame[1], 1.0);
    normal = vec4(frame[2], 1.0);
    light = vec4(lightDirection(frame, 0), 1.0);
    view = vec4(viewDirection(frame), 1.0);
}
