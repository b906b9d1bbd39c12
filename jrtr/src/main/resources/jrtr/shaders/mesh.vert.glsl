#version 330 core
// Vertices to world space and to the picture. Directions are left to the fragment shader, which finds them in the tangent
// frame of its own point (jrtr/tangent_frame.glsl).

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
// xyz the tangent, w its handedness.
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
