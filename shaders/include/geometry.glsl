#include "include/patch_state.glsl"

// Images that geometry.frag writes: its outputs view, normal, tangent and albedo.
uniform sampler2D views;
uniform sampler2D normals;
uniform sampler2D tangents;
uniform sampler2D albedos;
