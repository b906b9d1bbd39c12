#include "include/color_table.glsl"

// Colors of power, tabulated over (u, v) and slices of w in levels of ever wider averages, tile by tile as pixels need them; for
// pixels that see more than a point (docs/color-tables.md).

// COLOR_POINT_LEVELS: 1 where the finest level is for pixels that see a point alone.

// How the pixel of each fragment looks into them (footprints.frag): (u, v, w) in the middle, and the level, or -1 where nothing is
// diffracted; by how much (u, v, w) changes along the wide and the minor axis of what it sees, and in how many places it looks.
uniform sampler2D footprintCenters;
uniform sampler2D footprintMajorAxes;
uniform sampler2D footprintMinorAxes;
// Seen from the minor axis it is a trapezoid: the ratio of its shorter edge to its longer one.
uniform sampler2D footprintEdges;

// One texel a level: u and v of its first coefficient, texels per unit, tiles across, and what its power counts.
uniform sampler2D colorLevels;

// A level's grid, and what its power counts.
vec4 levelAt(float level) {
    return textureLod(colorLevels, vec2((level + 0.5) / float(textureSize(colorLevels, 0).x), 0.5), 0.0);
}

ColorGrid levelGrid(vec4 texel, float level) {
    return ColorGrid(texel.xx, texel.y, texel.zz, level * float(COLOR_SLICES));
}

// No two directions have a longer sum; what a pixel sees at a silhouette, taken as even, may reach beyond.
const float LONGEST = 2.0;

// The mean over what the pixel of this fragment sees, in a level.
vec3 seenXyz(int level, vec3 middle, vec4 wide, vec4 narrow, float edges) {
    vec4 texel = texelFetch(colorLevels, ivec2(level, 0), 0);
    ColorGrid grid = levelGrid(texel, float(level));
    // A trapezoid's density falls from the end of its shorter edge to that of the longer one; these are halves of a length of 1.
    float shorter = 0.5 * min(edges, 0.999);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (float i = 0.5; i < wide.w; i += 1.0) {
        float t = i / wide.w - 0.5;
        float weight = clamp((0.5 - abs(t)) / (0.5 - shorter), 0.0, 1.0);
        weights += weight;
        for (float j = 0.5; j < narrow.w; j += 1.0) {
            vec3 uvw = middle + t * wide.xyz + (j / narrow.w - 0.5) * narrow.xyz;
            uvw *= LONGEST / max(LONGEST, length(uvw));
            vec3 xyz = COLOR_FILTER(uvw.xy, uvw.z, grid);
            if (xyz.y == MISSING) {
                return vec3(MISSING);
            }
            sum += weight * xyz;
        }
    }
    return texel.w / (weights * narrow.w) * sum;
}

// At a point, in the level that is for points.
vec3 pointXyz(vec3 uvw) {
    vec4 texel = texelFetch(colorLevels, ivec2(0, 0), 0);
    vec3 xyz = cubicXyz(uvw.xy, uvw.z, levelGrid(texel, 0.0));
    return xyz.y == MISSING ? xyz : texel.w * xyz;
}

// MISSING where a tile does not exist.
vec3 diffractedXyz(vec3 uvw) {
    ivec2 slot = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(footprintCenters, slot, 0);
    if (place.w < 0.0) {
        return vec3(0.0);
    }
    vec4 wide = texelFetch(footprintMajorAxes, slot, 0);
    vec4 narrow = texelFetch(footprintMinorAxes, slot, 0);
    float edges = texelFetch(footprintEdges, slot, 0).r;
    int level = int(place.w);
    // Polynomials along w may pass below nothing where all is dark.
#if COLOR_POINT_LEVELS == 1
    vec3 xyz = vec3(0.0);
    // Loops, of no more than one turn: renderers that take pixels together go through what any of them may do, but leave a loop that none
    // is in.
    for (; level == 0; level = -1) {
        xyz = pointXyz(place.xyz);
    }
    for (; level > 0; level = -1) {
        xyz = seenXyz(level, place.xyz, wide, narrow, edges);
    }
    return max(xyz, vec3(0.0));
#else
    return max(seenXyz(level, place.xyz, wide, narrow, edges), vec3(0.0));
#endif
}
