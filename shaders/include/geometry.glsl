// Images that geometry.frag writes: its outputs view, normal, tangent and albedo.
uniform sampler2D views;
uniform sampler2D normals;
uniform sampler2D tangents;
uniform sampler2D albedos;

// The views' w, the number of the patch, where nothing is drawn.
const float NO_SKIN = 0.0;
