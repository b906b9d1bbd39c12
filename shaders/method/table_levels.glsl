#include "include/color_table.glsl"
#include "include/footprint.glsl"

// Color tables over (u, v) and slices of w with mip levels, averaged over footprints. The variance of a level's blur doubles from level to
// level. Tiles are baked when pixels need them (docs/color-tables.md).

// COLOR_POINT_LEVELS: 1 if level 0 is for samples that see a single point. TAP_FILTER: filter for taps in all other levels.
#ifndef TAP_FILTER
#define TAP_FILTER COLOR_FILTER
#endif

// One texel per level: u, and equal to it v, of the first coefficient; texels per unit; tiles along either axis; the level's scale.
uniform sampler2D colorLevels;

// Greatest length of (u, v, w); taps at a silhouette may lie beyond and are moved back.
const float LONGEST = 2.0;

vec4 levelTexel(float level) {
    return textureLod(colorLevels, vec2((level + 0.5) / float(textureSize(colorLevels, 0).x), 0.5), 0.0);
}

ColorGrid levelGrid(vec4 texel, float level) {
    return ColorGrid(texel.xx, texel.y, texel.zz, level * float(COLOR_SLICES));
}

// Mean over a footprint's taps in a level; MISSING where a tile is not resident.
vec3 levelXyz(Footprint footprint, float level) {
    vec4 texel = levelTexel(level);
    ColorGrid grid = levelGrid(texel, level);
#if MOST_TAPS == 1
    vec3 xyz = TAP_FILTER(footprint.center.xy, footprint.center.z, grid);
    return xyz.y == MISSING ? xyz : texel.w * xyz;
#else
    float step = 1.0 / footprint.taps;
    vec3 sum = vec3(0.0);
    for (float at = 0.5 * step - 0.5; at < 0.5; at += step) {
        vec3 uvw = footprint.center + at * footprint.axis;
        uvw *= LONGEST / max(LONGEST, length(uvw));
        vec3 xyz = TAP_FILTER(uvw.xy, uvw.z, grid);
        if (xyz.y == MISSING) {
            return xyz;
        }
        sum += xyz;
    }
    return step * texel.w * sum;
#endif
}

// Color at a point, from level 0, which is for points.
vec3 pointXyz(vec3 uvw) {
    vec4 texel = levelTexel(0.0);
    vec3 xyz = cubicXyz(uvw.xy, uvw.z, levelGrid(texel, 0.0));
    return xyz.y == MISSING ? xyz : texel.w * xyz;
}

// Color of a footprint; MISSING where a tile is not resident.
vec3 footprintXyz(Footprint footprint) {
#if COLOR_POINT_LEVELS == 1
    vec3 xyz = vec3(0.0);
    // Loops of one iteration: a software renderer runs both branches of an "if" for its pixels, but skips a loop that none of them enters.
    float level = footprint.level;
    for (; level == 0.0; level = -1.0) {
        xyz = pointXyz(footprint.center);
    }
    for (; level > 0.0; level = -1.0) {
        xyz = levelXyz(footprint, level);
    }
#else
    vec3 xyz = levelXyz(footprint, footprint.level);
#endif
    // Interpolation along w may give values below zero in the dark.
    return max(xyz, vec3(0.0));
}
