#version 330 core
#include "jrtr/tangent_frame.glsl"

// What a pixel of a mesh shows, as numbers.

layout(location = 0) out vec4 position;
layout(location = 1) out vec4 tangent;
layout(location = 2) out vec4 bitangent;
layout(location = 3) out vec4 normal;
// Towards the first light, tangent frame; w is texture coordinate u.
layout(location = 4) out vec4 lightAndU;
// Towards the viewer, tangent frame; w is texture coordinate v.
layout(location = 5) out vec4 viewAndV;

void main() {
    mat3 frame = tangentFrame();
    position = vec4(worldPosition, 1.0);
    tangent = vec4(frame[0], 1.0);
    bitangent = vec4(frame[1], 1.0);
    normal = vec4(frame[2], 1.0);
    lightAndU = vec4(lightDirection(frame, 0), surfaceCoordinate.x);
    viewAndV = vec4(viewDirection(frame), surfaceCoordinate.y);
}
