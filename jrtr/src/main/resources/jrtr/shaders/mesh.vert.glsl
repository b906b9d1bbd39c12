#version 330 core
// Transforms vertices to world space and to clip space. The fragment shader computes directions to light and viewer, in the tangent frame
// at its fragment (jrtr/tangent_frame.glsl).

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
// xyz is the tangent; w is the handedness h, 1 or -1: the bitangent is h (normal x tangent).
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 textureCoordinate;

uniform mat4 modelToWorld;
// Inverse transpose of modelToWorld's linear part.
uniform mat3 normalToWorld;
// -1 where modelToWorld mirrors, else 1.
uniform float mirror;
uniform mat4 worldToClip;

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec2 surfaceCoordinate;

void main() {
    vec4 world = modelToWorld * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = normalize(normalToWorld * normal);
    worldTangent = vec4(normalize(mat3(modelToWorld) * tangent.xyz), mirror * tangent.w);
    surfaceCoordinate = textureCoordinate;
    gl_Position = worldToClip * world;
}
