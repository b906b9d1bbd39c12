#include "jrtr/lights.glsl"

// What mesh.vert.glsl hands to a fragment shader, and the eye that the engine sets.

// Metres, world space.
in vec3 worldPosition;
// Interpolated, so not of unit length.
in vec3 worldNormal;
// Interpolated; w is the handedness, positive or negative.
in vec4 worldTangent;
// Texture coordinate; v grows upwards in pictures.
in vec2 surfaceCoordinate;

// The camera's centre of projection, world space.
uniform vec3 eyePosition;
