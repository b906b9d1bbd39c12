#include "include/color_spline.glsl"

// Colors of power, tabulated over (u, v) and slices of w in levels of ever wider averages, tile by tile as pixels need them; for
// pixels that see more than a point (docs/color-tables.md).

// How the pixel of each fragment looks into them (footprints.frag): (u, v, w) in the middle, and the level, or -1 where nothing is
// diffracted; by how much (u, v, w) changes along the wide and the minor axis of what it sees, and in how many places it looks.
uniform sampler2D footprintCenters;
uniform sampler2D footprintMajorAxes;
uniform sampler2D footprintMinorAxes;

// Number of each tile's cell among the texels, plus one; 0 for those that do not exist; and that of the same tile of the next slice, as
// look-ups want both. Slices of one level, then of the next.
uniform sampler2DArray colorTiles;
// One texel a level: u and v of its first coefficient, texels per unit, tiles across, and what its power counts.
uniform sampler2D colorLevels;
// Texels along a tile's side between which look-ups of its own fall, and cells along a layer's side.
uniform float colorTileSide;
uniform int colorCellsAcross;
// One over that side, over the tiles across the list, over the texels of a layer's side, over the cells across it.
uniform float perColorTileSide;
uniform float perColorTiles;
uniform float perColorLayerSide;
uniform float perColorCellsAcross;

// What is looked up between texels is rounded to this share of one, so that a sum with a tile's place is exact, and a color the same
// wherever its tile lies; layers' sides are powers of two.
const float GRAINS = 8192.0;

// What a tile gives that does not exist, far above anything that is in one.
const float MISSING = 1e30;

// Texels of a level from its first one on; what lies beyond all tiles is looked up at their edge.
vec2 levelTexel(vec2 uv, vec4 grid) {
    return clamp((uv - grid.x) * grid.y, colorTileSide, colorTileSide * (grid.z - 1.0) - 0.01);
}

// The cells of a tile and of the next slice's; below 0 where the tile does not exist.
vec2 tileCells(vec2 tile, int layer) {
    return texelFetch(colorTiles, ivec3(ivec2(tile), layer), 0).rg - 1.0;
}

// First texel and layer of a cell. In floats: whole numbers below 2^24 are exact, and software renderers divide integers one by one.
vec3 cellPlace(float cell) {
    float across = float(colorCellsAcross);
    float row = floor((cell + 0.5) * perColorCellsAcross);
    float layer = floor((row + 0.5) * perColorCellsAcross);
    return vec3((colorTileSide + 3.0) * vec2(cell - row * across, row - layer * across), layer);
}

// X, Y, Z at a place of a level that is interpolated by cubic B-splines.
vec3 cubicXyz(vec3 uvw, int level, vec4 grid) {
    vec2 texel = levelTexel(uvw.xy, grid);
    vec2 tile = floor(texel / colorTileSide);
    vec2 inTile = texel - tile * colorTileSide;
    vec2 size = vec2(textureSize(colorTexels, 0).xy);
    SplinePlace place = splinePlace(inTile, vec2(1.0));
    vec4 corners = round(place.corners * GRAINS) / GRAINS;
    SlicePlace slices = slicePlace(uvw.z, COLOR_SLICES);
    vec3 xyz = vec3(0.0);
    int layer = level * COLOR_SLICES + slices.first;
    vec4 cells = vec4(tileCells(tile, layer), tileCells(tile, layer + 2));
    if (any(lessThan(cells, vec4(0.0)))) {
        return vec3(MISSING);
    }
    for (int i = 0; i < 4; ++i) {
        vec3 stored = cellPlace(cells[i]);
        // A tile begins a texel before its own.
        place.corners = (corners + (stored.xy + 1.0).xyxy) / size.xyxy;
        xyz += slices.weights[i] * splineXyz(place, stored.z);
    }
    return xyz;
}

// X, Y, Z at a place of a level that is interpolated along lines: a quarter of the look-ups. Where texels are taken as they are, software
// renderers are quicker to sample the nearest than to fetch by number, which asks each pixel for its mipmap.
vec3 linesXyz(vec3 uvw, int level, vec4 grid) {
    vec2 texel = levelTexel(uvw.xy, grid);
    vec2 tile = floor(texel * perColorTileSide);
    vec2 inTexels = round((texel - tile * colorTileSide) * GRAINS) / GRAINS + 1.5;
    SlicePlace slices = slicePlace(uvw.z, COLOR_SLICES);
    vec3 tilePlace = vec3((tile + 0.5) * perColorTiles, float(level * COLOR_SLICES + slices.first));
    vec4 cells = vec4(
            textureLod(colorTiles, tilePlace, 0.0).rg, textureLod(colorTiles, tilePlace + vec3(0.0, 0.0, 2.0), 0.0).rg);
    cells -= 1.0;
    if (any(lessThan(cells, vec4(0.0)))) {
        return vec3(MISSING);
    }
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec3 stored = cellPlace(cells[i]);
        vec3 place = vec3((inTexels + stored.xy) * perColorLayerSide, stored.z);
        vec3 root = textureLod(colorTexels, place, 0.0).rgb;
        xyz += slices.weights[i] * (root * root);
    }
    return xyz;
}

// Nearly as much with a tenth of the look-ups: linear between two slices, and between the spline's coefficients. Where texels are taken
// as they are, software renderers are quicker to sample the nearest than to fetch by number, which asks each pixel for its mipmap.
vec3 roughXyz(vec3 uvw, float level, vec4 grid) {
    vec2 texel = levelTexel(uvw.xy, grid);
    vec2 tile = floor(texel * perColorTileSide);
    vec2 inTexels = texel - tile * colorTileSide + 1.5;
    float at = clamp(-uvw.z * colorSlicesPerUnit, 0.0, float(COLOR_SLICES) - 1.001);
    float below = floor(at);
    vec3 tilePlace = vec3((tile + 0.5) * perColorTiles, level * float(COLOR_SLICES) + below);
    vec2 cells = textureLod(colorTiles, tilePlace, 0.0).rg - 1.0;
    if (min(cells.x, cells.y) < 0.0) {
        return vec3(MISSING);
    }
    vec3 stored = cellPlace(cells.x);
    vec3 root = textureLod(colorTexels, vec3((inTexels + stored.xy) * perColorLayerSide, stored.z), 0.0).rgb;
    stored = cellPlace(cells.y);
    vec3 next = textureLod(colorTexels, vec3((inTexels + stored.xy) * perColorLayerSide, stored.z), 0.0).rgb;
    return grid.w * mix(root * root, next * next, at - below);
}

#if COLOR_POINT_LEVELS == 1
#define meanXyz linesXyz
#else
#define meanXyz cubicXyz
#endif

// The mean over what the pixel of this fragment sees, in a level.
vec3 seenXyz(int level, vec3 middle, vec4 wide, vec4 narrow) {
    vec4 grid = texelFetch(colorLevels, ivec2(level, 0), 0);
    float rows = floor(narrow.w);
    // A trapezoid's density falls from the end of its shorter edge to that of the longer one; these are halves of a length of 1.
    float shorter = 0.5 * min((narrow.w - rows) / 0.9, 0.999);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (float i = 0.5; i < wide.w; i += 1.0) {
        float t = i / wide.w - 0.5;
        float weight = clamp((0.5 - abs(t)) / (0.5 - shorter), 0.0, 1.0);
        weights += weight;
        for (float j = 0.5; j < rows; j += 1.0) {
            vec3 xyz = meanXyz(middle + t * wide.xyz + (j / rows - 0.5) * narrow.xyz, level, grid);
            if (xyz.y == MISSING) {
                colorIsMissing = true;
                return vec3(0.0);
            }
            sum += weight * xyz;
        }
    }
    // Polynomials along w may pass below nothing where all is dark.
    return max(grid.w / (weights * rows) * sum, vec3(0.0));
}

// At a point, in the level that is for points.
vec3 pointXyz(vec3 uvw) {
    vec4 grid = texelFetch(colorLevels, ivec2(0, 0), 0);
    vec3 xyz = cubicXyz(uvw, 0, grid);
    if (xyz.y == MISSING) {
        colorIsMissing = true;
        return vec3(0.0);
    }
    return max(grid.w * xyz, vec3(0.0));
}

vec3 diffractedXyz(vec3 uvw) {
    ivec2 slot = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(footprintCenters, slot, 0);
    if (place.w < 0.0) {
        return vec3(0.0);
    }
    vec4 wide = texelFetch(footprintMajorAxes, slot, 0);
    vec4 narrow = texelFetch(footprintMinorAxes, slot, 0);
    int level = int(place.w);
#if COLOR_POINT_LEVELS == 1
    vec3 xyz = vec3(0.0);
    // Loops, of no more than one turn: renderers that take pixels together go through what any of them may do, but leave a loop that none
    // is in.
    for (; level == 0; level = -1) {
        xyz = pointXyz(place.xyz);
    }
    for (; level > 0; level = -1) {
        xyz = seenXyz(level, place.xyz, wide, narrow);
    }
    return xyz;
#else
    return seenXyz(level, place.xyz, wide, narrow);
#endif
}
