#version 330 core
#include "include/display.glsl"
#include "include/gain.glsl"
#include "sunbeam.glsl"

// A map of all views under one light, or a sphere of the material.

// Unit vector to the light: of the map in the surface's frame, of the sphere in the camera's.
uniform vec3 light;
// Rotation of the sphere, from its own frame to the camera's.
uniform mat3 turn;
// Lower left corner and side of the square, pixels.
uniform vec2 corner;
uniform float side;
uniform bool isMap;

layout(location = 0) out vec4 color;

// disc: place in the unit disc.
vec3 shaded(vec2 disc) {
    float square = dot(disc, disc);
    if (square >= 1.0) {
        return vec3(0.0);
    }
    vec3 onto = vec3(disc, sqrt(1.0 - square));
    vec3 wi = light;
    vec3 wr = onto;
    if (!isMap) {
        vec3 normal = onto * turn;
        vec3 tangent = normalize(vec3(normal.z, 0.0, -normal.x) + vec3(1e-9, 0.0, 0.0));
        mat3 frame = turn * mat3(tangent, cross(normal, tangent), normal);
        wi = light * frame;
        wr = vec3(0.0, 0.0, 1.0) * frame;
    }
    if (wi.z <= 0.0 || wr.z <= 0.0) {
        return vec3(0.0);
    }
    return displayLight(relativeRadiance(wi, wr) * sunbeamPower(diffractionVector(wi, wr), 0.0));
}

void main() {
    vec2 disc = 2.0 * (gl_FragCoord.xy - corner) / side - 1.0;
    vec3 sum = vec3(0.0);
    if (isMap) {
        sum = shaded(disc);
    } else {
        // Four samples a pixel, each as a screen shows it.
        for (int i = 0; i < 4; ++i) {
            sum += 0.25 * shaded(1.04 * (disc + (vec2(i & 1, i >> 1) - 0.5) / side));
        }
    }
    color = vec4(srgbCurve(sum), 1.0);
}
