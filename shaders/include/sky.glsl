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

// Slope variance of the gloss, 3.4 degrees, chosen by eye.
const float GLOSS_VARIANCE = 0.0036;

// Mirror image of a light in a glossy skin, by microfacets of normally distributed slopes (Cook and Torrance 1982), relative to a white
// surface that faces the light; 0 under an environment, which skyXyz shows, and without a sky, where skin is matt.
float lightGloss(vec3 wi, vec3 wr, float seen) {
    vec3 sum = wi + wr;
    float isGlossy = skyWeight > 0.0 && min(wi.z, wr.z) > 0.0 ? 1.0 - isEnvironment : 0.0;
    float cosine = max(sum.z * inversesqrt(dot(sum, sum)), 0.1);
    float square = 1.0 / (cosine * cosine);
    float density = exp(0.5 * (1.0 - square) / GLOSS_VARIANCE) * square * square / (8.0 * GLOSS_VARIANCE);
    return isGlossy * glossShare(vec3(wr.xy, 0.5 * length(sum)), seen) * density / max(wr.z, 0.2);
}

// Share of the body's light that is left: what gloss mirrors under an environment does not reach the body.
float belowGloss(vec3 wr, float seen) {
    return 1.0 - isEnvironment * glossShare(wr, seen);
}
