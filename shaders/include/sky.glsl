// A sky, brightest at its zenith, with a soft bright window: its reflection by a glossy skin, and the share of its ambient light.

// Luminance of the zenith; 0 for no sky.
uniform float skyWeight;

// Linear XYZ, relative to the luminance of the zenith; BELOW is the light from below the horizon.
const vec3 ZENITH = vec3(0.93, 1.0, 1.17);
const vec3 HORIZON = vec3(0.15, 0.155, 0.16);
const vec3 BELOW = vec3(0.05, 0.05, 0.045);
// Middle and half sides of the window in the plane z = 1, through which a direction (x, y, 1) points; its light relative to the zenith's.
const vec2 WINDOW = vec2(-0.55, 0.4);
const vec2 WINDOW_SIDES = vec2(0.34, 0.26);
const float WINDOW_LIGHT = 5.0;

// Linear XYZ of the sky, or of what lies below the horizon, in a direction in world space.
vec3 skyXyz(vec3 direction) {
    float height = clamp(direction.z, 0.0, 1.0);
    vec3 above = mix(HORIZON, ZENITH, height * height * (3.0 - 2.0 * height));
    vec2 inside = 1.0 - smoothstep(0.7, 1.3, abs(direction.xy / max(direction.z, 0.1) - WINDOW) / WINDOW_SIDES);
    above += WINDOW_LIGHT * inside.x * inside.y * ZENITH;
    return skyWeight * mix(BELOW, above, clamp(20.0 * direction.z + 0.5, 0.0, 1.0));
}

// Share of the ambient light that a surface receives; seen: share of the sky that is visible from it.
float skyShare(vec3 normal, float seen) {
    return skyWeight > 0.0 ? seen * (0.6 + 0.4 * normal.z) : seen;
}

// Reflection of the sky by a skin, linear XYZ. frame: columns T, B, N in world space; wr: towards the viewer, in the frame.
vec3 glossXyz(mat3 frame, vec3 wr, float seen) {
    float grazing = 1.0 - clamp(wr.z, 0.0, 1.0);
    float square = grazing * grazing;
    float reflectance = 0.04 + 0.96 * square * square * grazing;
    return min(reflectance, 0.35) * seen * seen * skyXyz(frame * vec3(-wr.xy, wr.z));
}
