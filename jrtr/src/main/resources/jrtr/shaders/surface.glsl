#include "jrtr/lights.glsl"

// Inputs of a fragment shader from mesh.vert.glsl, and the position of the eye, which the engine sets.

// Position in world space, meters.
in vec3 worldPosition;
// Normal in world space; interpolated, so not of unit length.
in vec3 worldNormal;
// Tangent in world space, interpolated; the sign of w is the handedness.
in vec4 worldTangent;
// Texture coordinate; v grows upwards in pictures.
in vec2 surfaceCoordinate;

// The camera's center of projection in world space, meters.
uniform vec3 eyePosition;
