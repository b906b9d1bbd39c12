#version 330 core
// Draws one triangle in the far plane that covers the viewport. Its corners (-1, -1), (3, -1), (-1, 3) follow from the vertex number.
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, 1.0, 1.0);
}
