#include "jrtr/surface.glsl"

// Tangent frame at a fragment: x tangent, y bitangent, z normal. The thesis computes it per vertex (algorithm 3.2).

// Cosine and sine of the frame's rotation about the normal, counter-clockwise seen from outside. They are uniforms, because software
// renderers would compute them for each fragment.
uniform float tangentCosine;
uniform float tangentSine;

// Rotates a vector about an orthogonal axis of unit length (Rodrigues); turn is the cosine and sine of the angle.
vec3 turnedAbout(vec3 axis, vec3 vector, vec2 turn) {
    return turn.x * vector + turn.y * cross(axis, vector);
}

// Returns 1, or -1 where the texture is mirrored.
float frameHandedness() {
    return worldTangent.w < 0.0 ? -1.0 : 1.0;
}

// Returns the tangent frame about a normal of any length, rotated by an angle whose cosine and sine are turn. Its columns are T, B, N in
// world space: orthonormal, left-handed where the texture is mirrored.
mat3 tangentFrameAbout(vec3 direction, vec2 turn) {
    vec3 normal = normalize(direction);
    vec3 across = worldTangent.xyz - dot(worldTangent.xyz, normal) * normal;
    // Between vertices with opposite tangents, the interpolated tangent may be zero; the result is then zero instead of NaN.
    vec3 tangent = across * inversesqrt(max(dot(across, across), 1e-30));
    tangent = turnedAbout(normal, tangent, turn);
    return mat3(tangent, frameHandedness() * cross(normal, tangent), normal);
}

mat3 tangentFrame() {
    return tangentFrameAbout(worldNormal, vec2(tangentCosine, tangentSine));
}

// Returns wr, the direction towards the viewer, in the frame.
vec3 viewDirection(mat3 frame) {
    return normalize(eyePosition - worldPosition) * frame;
}
