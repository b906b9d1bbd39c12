// The lights that the engine sets (jrtr.scene.LightUniforms).

const int MAX_LIGHTS = 8;
uniform int lightCount;
// Unit vectors towards the lights, world space.
uniform vec3 lightDirections[MAX_LIGHTS];
// Linear, in the unit that the application's shaders agree on.
uniform vec3 lightRadiances[MAX_LIGHTS];

// Towards a light, in the frame of a surface (columns T, B, N in world space): wi.
vec3 lightDirection(mat3 frame, int light) {
    return lightDirections[light] * frame;
}
