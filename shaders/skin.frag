#version 330 core
#include "jrtr/lights.glsl"
#include "include/blend.glsl"
#include "include/geometry.glsl"
#include "include/radiance.glsl"

// A skin under its lights: diffraction, texture and diffuse part, from what geometry.frag found in each pixel.

// Number of the texel of geometry.frag's images that each pixel lights, counted row by row; negative for none.
uniform sampler2D sources;

// Linear XYZ; alpha 1, the skin's coverage, or -1 where a color was missing (sunbeam.app.scene.SkinFootprints).
layout(location = 0) out vec4 radiance;

// Where light or viewer lies in or below the tangent plane, as relief in the normals can have it, nothing is diffracted; nor where the
// body alone is asked for, which then costs little.
vec3 diffractedTowards(vec3 wi, vec3 wr) {
    if (diffractionWeight == 0.0 || wi.z <= 0.0 || wr.z <= 0.0) {
        return vec3(0.0);
    }
    return diffractedRadiance(wi, wr);
}

void main() {
    int source = int(texelFetch(sources, ivec2(gl_FragCoord.xy), 0).r);
    if (source < 0) {
        discard;
    }
    int width = textureSize(views, 0).x;
    ivec2 pixel = ivec2(source % width, source / width);
    vec3 wr = texelFetch(views, pixel, 0).xyz;
    vec4 normal = texelFetch(normals, pixel, 0);
    vec3 tangent = texelFetch(tangents, pixel, 0).xyz;
    mat3 frame = mat3(tangent, normal.w * cross(normal.xyz, tangent), normal.xyz);
    vec3 albedo = LINEAR_SRGB_TO_XYZ * texelFetch(albedos, pixel, 0).rgb;
    vec3 sum = vec3(0.0);
    for (int light = 0; light < lightCount; ++light) {
        vec3 wi = lightDirection(frame, light);
        // Lights are white, so that their luminance says all.
        sum += lightRadiances[light].y * blended(diffractedTowards(wi, wr), albedo, wi.z);
    }
    radiance = vec4(sum, colorIsMissing ? -1.0 : 1.0);
}
