#include "include/octahedron.glsl"
#include "include/srgb.glsl"

// The surroundings of a mesh (app.render.LightTexture): their reflection by a glossy skin, and the share of their ambient light.

// Radiance from all directions, linear Rec. 709, on an octahedron, and its factor; 0 for none.
uniform sampler2D skyMap;
uniform float skyWeight;
// Cosine and sine of the angle by which the surroundings are turned about z; 1 if they light the scene, 0 beside its own lights.
uniform vec2 skyTurn;
uniform float isEnvironment;

// Linear XYZ of the surroundings in a direction in world space.
vec3 skyXyz(vec3 direction) {
    vec2 turned = vec2(dot(skyTurn, direction.xy), skyTurn.x * direction.y - skyTurn.y * direction.x);
    vec2 place = onOctahedron(vec3(turned, direction.z));
    return skyWeight * (LINEAR_SRGB_TO_XYZ * textureLod(skyMap, 0.5 + 0.5 * place, 0.0).rgb);
}

// Share of the ambient light that a surface receives; seen: share of the sky that is visible from it.
float skyShare(vec3 normal, float seen) {
    return skyWeight > 0.0 ? seen * (0.6 + 0.4 * normal.z) : seen;
}

// Share of the surroundings that a skin mirrors; seen: as for skyShare.
float glossShare(vec3 wr, float seen) {
    float grazing = 1.0 - clamp(wr.z, 0.0, 1.0);
    float square = grazing * grazing;
    float reflectance = 0.04 + 0.96 * square * square * grazing;
    return min(reflectance, 0.35) * seen * seen;
}

// Reflection of the surroundings by a skin, linear XYZ. frame: columns T, B, N in world space; wr: towards the viewer, in the frame.
vec3 glossXyz(mat3 frame, vec3 wr, float seen) {
    return glossShare(wr, seen) * skyXyz(frame * vec3(-wr.xy, wr.z));
}

// Share of the body's light that is left: what gloss mirrors under an environment does not reach the body.
float belowGloss(vec3 wr, float seen) {
    return 1.0 - isEnvironment * glossShare(wr, seen);
}
