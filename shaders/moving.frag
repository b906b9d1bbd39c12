#version 330 core
#include "jrtr/lights.glsl"
#include "jrtr/view_rays.glsl"
#include "include/blend.glsl"
#include "include/display.glsl"
#include "include/look.glsl"
#include "include/packed_surface.glsl"
#include "include/radiance.glsl"

// A skin that moves, as a screen shows it, under the first light, by those levels of colours that exist: each pixel looks in a few
// places of the finest of them that is fine enough.

// moving_geometry.frag's.
uniform sampler2D surfaces;

uniform float exposure;

// sRGB in [0, 1].
layout(location = 0) out vec4 color;

// Change of (u, v, w) to the pixel beside; none at the skin's edge.
vec3 inside(vec3 change, float coverageChange) {
    return coverageChange == 0.0 ? change : vec3(0.0);
}

// Along the wide side of what the pixel sees, in a level.
vec3 alongXyz(Look look, int level) {
    vec4 grid = texelFetch(colourLevels, ivec2(level, 0), 0);
    vec3 sum = vec3(0.0);
    for (float i = 0.5; i < look.wide.w; i += 1.0) {
        vec3 xyz = roughXyz(look.place.xyz + (i / look.wide.w - 0.5) * look.wide.xyz, level, grid);
        if (xyz.y == MISSING) {
            return xyz;
        }
        sum += xyz;
    }
    return sum / look.wide.w;
}

vec3 existingXyz(Look look) {
    for (int level = int(look.place.w); level < levels; ++level) {
        vec3 xyz = alongXyz(look, level);
        if (xyz.y < MISSING) {
            return xyz;
        }
    }
    return vec3(0.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 texel = texelFetch(surfaces, pixel, 0);
    float coverage = showsSkin(texel) ? 1.0 : 0.0;
    vec2 coverageChange = vec2(dFdx(coverage), dFdy(coverage));
    // Software renderers leave out what all pixels of a square have ended; a return they do not.
    if (coverage == 0.0) {
        discard;
    }
    Skin skin = unpackedSkin(texel);
    vec3 wi = lightDirection(skin.frame, 0);
    vec3 wr = viewAt(gl_FragCoord.xy) * skin.frame;
    vec3 uvw = diffractionVector(wi, wr);
    // Beside pixels that have ended they are nothing, and not used.
    vec3 a = inside(dFdx(uvw), coverageChange.x);
    vec3 b = inside(dFdy(uvw), coverageChange.y);
    vec3 diffracted = vec3(0.0);
    if (wi.z > 0.0 && wr.z > 0.0) {
        vec3 xyz = existingXyz(lookOver(uvw, a, b));
        diffracted = loopsWereCut() ? vec3(0.0) : relativeRadiance(wi, wr) * xyz;
    }
    vec3 albedo = LINEAR_SRGB_TO_XYZ * skin.albedo;
    vec3 light = displayLight(lightRadiances[0].y * blended(diffracted, albedo, wi.z), exposure);
    color = vec4(srgbCurveByRoots(light), 1.0);
}
