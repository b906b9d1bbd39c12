#version 330 core
#include "jrtr/lights.glsl"
#include "include/blend.glsl"
#include "include/display.glsl"
#include "include/geometry.glsl"
#include "include/look.glsl"
#include "include/radiance.glsl"

// A skin that moves, as a screen shows it, under the first light, by those levels of colours that exist: each pixel looks in a few
// places of the finest of them that is fine enough.

uniform float exposure;
// sRGB.
uniform vec3 background;

// sRGB in [0, 1].
layout(location = 0) out vec4 color;

// Change of (u, v, w) to the pixel beside; none at the skin's edge.
vec3 inside(vec3 change, float coverageChange) {
    return coverageChange == 0.0 ? change : vec3(0.0);
}

vec3 existingXyz(Look look) {
    look.narrow.w = min(look.narrow.w, 1.9);
    for (int level = int(look.place.w); level < levels; ++level) {
        vec3 xyz = seenXyz(level, look.place.xyz, look.wide, look.narrow);
        if (xyz.y < MISSING) {
            return xyz;
        }
    }
    return vec3(0.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 view = texelFetch(views, pixel, 0);
    vec4 normal = texelFetch(normals, pixel, 0);
    vec3 tangent = texelFetch(tangents, pixel, 0).xyz;
    vec3 wi = lightDirection(mat3(tangent, normal.w * cross(normal.xyz, tangent), normal.xyz), 0);
    vec3 uvw = diffractionVector(wi, view.xyz);
    vec3 a = inside(dFdx(uvw), dFdx(view.w));
    vec3 b = inside(dFdy(uvw), dFdy(view.w));
    if (view.w == 0.0) {
        color = vec4(background, 1.0);
        return;
    }
    vec3 diffracted = vec3(0.0);
    if (wi.z > 0.0 && view.z > 0.0) {
        vec3 xyz = existingXyz(lookOver(uvw, a, b));
        diffracted = loopsWereCut() ? vec3(0.0) : relativeRadiance(wi, view.xyz) * xyz;
    }
    vec3 albedo = LINEAR_SRGB_TO_XYZ * texelFetch(albedos, pixel, 0).rgb;
    color = vec4(displayColor(lightRadiances[0].y * blended(diffracted, albedo, wi.z), exposure), 1.0);
}
