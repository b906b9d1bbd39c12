// The images of geometry.frag.
uniform sampler2D views;
uniform sampler2D normals;
uniform sampler2D tangents;
uniform sampler2D albedos;
