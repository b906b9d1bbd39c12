#version 330 core
#include "jrtr/tangent_frame.glsl"
#include "include/blend.glsl"
#include "include/gain.glsl"
#include "method/method.glsl"

// A skin: diffraction, texture and diffuse part, in the tangent frame of each point.

// Linear light; the sampler undoes the sRGB curve.
uniform sampler2D bodyTexture;

// Linear XYZ; alpha 1, so that covered pixels are known.
layout(location = 0) out vec4 radiance;

// Where light or viewer lies in or below the tangent plane, as relief in the normals can have it, nothing is diffracted.
vec3 diffractedTowards(vec3 wi, vec3 wr) {
    if (wi.z <= 0.0 || wr.z <= 0.0) {
        return vec3(0.0);
    }
    return relativeRadiance(wi, wr) * diffractedXyz(diffractionVector(wi, wr));
}

void main() {
    mat3 frame = tangentFrame();
    vec3 wr = viewDirection(frame);
    vec3 albedo = linearSrgbToXyz(texture(bodyTexture, surfaceCoordinate).rgb);
    vec3 sum = vec3(0.0);
    for (int light = 0; light < lightCount; ++light) {
        vec3 wi = lightDirection(frame, light);
        // Lights are white, so that their luminance says all.
        sum += lightRadiances[light].y * blended(diffractedTowards(wi, wr), albedo, wi.z);
    }
    radiance = vec4(sum, 1.0);
}
