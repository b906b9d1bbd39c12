#include "jrtr/surface.glsl"

// The tangent frame at a fragment: x tangent, y bitangent, z normal (thesis algorithm 3.2, there per vertex).

// Cosine and sine of the frame's turn about the normal, counter-clockwise seen from outside, the same everywhere: software renderers
// would find them anew for each fragment.
uniform float tangentCosine;
uniform float tangentSine;

// Rodrigues' rotation of a vector about an axis of unit length that is orthogonal to it.
vec3 turnedAbout(vec3 axis, vec3 vector, vec2 turn) {
    return turn.x * vector + turn.y * cross(axis, vector);
}

// 1, or -1 where the texture is mirrored.
float frameHandedness() {
    return worldTangent.w < 0.0 ? -1.0 : 1.0;
}

// Columns T, B, N in world space about a normal of any length: orthonormal, left-handed where the texture is mirrored. turn: cosine
// and sine, as above.
mat3 tangentFrameAbout(vec3 direction, vec2 turn) {
    vec3 normal = normalize(direction);
    vec3 across = worldTangent.xyz - dot(worldTangent.xyz, normal) * normal;
    // Tangents that cancel between two vertices have no direction; a zero vector is better than NaN.
    vec3 tangent = across * inversesqrt(max(dot(across, across), 1e-30));
    tangent = turnedAbout(normal, tangent, turn);
    return mat3(tangent, frameHandedness() * cross(normal, tangent), normal);
}

mat3 tangentFrame() {
    return tangentFrameAbout(worldNormal, vec2(tangentCosine, tangentSine));
}

// Towards the viewer, in the frame: wr.
vec3 viewDirection(mat3 frame) {
    return normalize(eyePosition - worldPosition) * frame;
}
