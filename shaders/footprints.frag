#version 330 core
#include "jrtr/lights.glsl"
#include "include/frame.glsl"
#include "include/geometry.glsl"
#include "include/footprint.glsl"

// How each pixel of a skin looks into levels of colors (method/table_levels.glsl) under the first light: what of (u, v, w) it
// sees, by the differences to its neighbors, in which level, and in how many places.

// Number of the texel of geometry.frag's images that each pixel lights, counted row by row; negative for none.
uniform sampler2D sources;
// Of relief that is finer than a pixel.
uniform float slopeVariance;
// Pixels along a side of what each stands for.
uniform float stride;

// (u, v, w) in the middle; w is the level, or -1 where nothing is diffracted.
layout(location = 0) out vec4 place;
// By how much (u, v, w) changes along the major axis of what it sees; w is in how many places it looks there.
layout(location = 1) out vec4 majorAxis;
// As much of the minor axis.
layout(location = 2) out vec4 minorAxis;
// Seen from the minor axis, the parallelogram is a trapezoid: the ratio of its shorter edge to its longer one.
layout(location = 3) out float edges;

bool isSkin(ivec2 pixel, ivec2 size) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size)) && texelFetch(views, pixel, 0).w > 0.0;
}

mat3 frameAt(ivec2 pixel) {
    vec4 normal = texelFetch(normals, pixel, 0);
    vec3 tangent = texelFetch(tangents, pixel, 0).xyz;
    return mat3(tangent, normal.w * cross(normal.xyz, tangent), normal.xyz);
}

vec3 uvwAt(ivec2 pixel) {
    return diffractionVector(lightDirection(frameAt(pixel), 0), texelFetch(views, pixel, 0).xyz);
}

// Change of (u, v, w) from one pixel to the next: the mean of those on both sides, or the smaller where the other leads over an
// edge to another part of the skin.
vec3 change(ivec2 pixel, ivec2 step, vec3 uvw) {
    ivec2 size = textureSize(views, 0);
    bool hasNext = isSkin(pixel + step, size);
    bool hasLast = isSkin(pixel - step, size);
    vec3 next = hasNext ? uvwAt(pixel + step) - uvw : vec3(0.0);
    vec3 last = hasLast ? uvw - uvwAt(pixel - step) : vec3(0.0);
    if (!hasNext || !hasLast) {
        return next + last;
    }
    float nextLength = dot(next, next);
    float lastLength = dot(last, last);
    if (nextLength > 9.0 * lastLength) {
        return last;
    }
    return lastLength > 9.0 * nextLength ? next : 0.5 * (next + last);
}

void main() {
    int source = int(texelFetch(sources, ivec2(gl_FragCoord.xy), 0).r);
    if (source < 0) {
        discard;
    }
    int width = textureSize(views, 0).x;
    ivec2 pixel = ivec2(source % width, source / width);
    mat3 frame = frameAt(pixel);
    vec3 wi = lightDirection(frame, 0);
    vec4 view = texelFetch(views, pixel, 0);
    vec3 wr = view.xyz;
    if (wi.z <= 0.0 || wr.z <= 0.0 || view.w < 2.0) {
        place = vec4(0.0, 0.0, 0.0, -1.0);
        majorAxis = vec4(0.0);
        minorAxis = vec4(0.0);
        edges = 0.0;
        return;
    }
    vec3 uvw = diffractionVector(wi, wr);
    vec3 a = stride * change(pixel, ivec2(1, 0), uvw);
    vec3 b = stride * change(pixel, ivec2(0, 1), uvw);
    Footprint footprint = footprintOf(uvw, a, b, slopeVariance);
    place = footprint.place;
    majorAxis = footprint.wide;
    minorAxis = footprint.narrow;
    edges = footprint.edges;
}
