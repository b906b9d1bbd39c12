// Directional lights, which the engine sets (jrtr.scene.Light).

const int MAX_LIGHTS = 8;
// Unit vectors towards the lights, world space.
uniform vec3 lightDirections[MAX_LIGHTS];
// Linear color, in the unit of the application's shaders.
uniform vec3 lightRadiances[MAX_LIGHTS];

// Returns wi, the direction towards a light, in the frame of a surface, whose columns are T, B, N in world space.
vec3 lightDirection(mat3 frame, int light) {
    return lightDirections[light] * frame;
}
