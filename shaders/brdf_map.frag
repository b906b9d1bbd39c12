#version 330 core
#include "include/radiance.glsl"

// A BRDF map: the pixel at (x, y) of the unit disc shows the direction (x, y, sqrt(1 - x^2 - y^2)).

// Unit vector towards the light, in the patch's frame; cosine and sine of the patch's counterclockwise turn in the map.
uniform vec3 lightDirection;
uniform vec2 patchTurn;
// Size of the whole map in pixels.
uniform vec2 mapSize;

// Linear XYZ of the relative radiance; alpha 1 inside the disc, 0 outside.
layout(location = 0) out vec4 radiance;

void main() {
    vec2 disc = 2.0 * gl_FragCoord.xy / mapSize - 1.0;
    float radiusSquared = dot(disc, disc);
    if (radiusSquared >= 1.0) {
        radiance = vec4(0.0);
        return;
    }
    vec2 turned = vec2(dot(disc, patchTurn), dot(disc, vec2(-patchTurn.y, patchTurn.x)));
    vec3 wr = vec3(turned, sqrt(1.0 - radiusSquared));
    radiance = vec4(diffractedRadiance(lightDirection, wr), 1.0);
}
