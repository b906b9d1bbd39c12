// Look-ups in tables of colors, as sunbeam.precompute.colortable.TableLookUp does them: in tiles of (u, v), by one of two filters through
// square roots of X, Y and Z, and along w by Lagrange's polynomial through SLICE_TAPS slices.

// COLOR_SLICES: slices in w, 1 where one light has all; COLOR_TILE_SIDE and COLOR_LAYER_SIDE: texels along a tile's side, and along a
// layer's; COLOR_FILTER: cubicXyz or linearXyz.

// The filters' coefficients: a tile in each cell, with a texel before its own and two behind them.
uniform sampler2DArray colorTexels;
// Number of each tile's cell plus one, 0 for those that do not exist; and that of the same tile of the next slice, as look-ups want both.
// Slices of one level, then of the next.
uniform sampler2DArray colorTiles;
// One over the tiles across that list, and down.
uniform vec2 perColorTiles;
// Slices per unit of |w|; the first lies at 0.
uniform float colorSlicesPerUnit;

#ifndef SLICE_TAPS
#if COLOR_SLICES == 1
#define SLICE_TAPS 1
#else
#define SLICE_TAPS 4
#endif
#endif

// What is looked up between texels is rounded to this share of one, so that a sum with a tile's place is exact, and a color the same
// wherever its tile lies; layers' sides are powers of two.
const float GRAINS = 8192.0;
const float CELL_SIDE = COLOR_TILE_SIDE + 3.0;
const float CELLS_ACROSS = floor(COLOR_LAYER_SIDE / CELL_SIDE);

// What a tile gives that does not exist, far above any color: no color is missing that is below it.
const float MISSING = 1e30;

// Where a level's coefficients lie: u and v (or what stands in for them) of the first, how many a unit, how many tiles there are across and
// down, and the number of its first slice.
struct ColorGrid {
    vec2 first;
    float perUnit;
    vec2 tiles;
    float slice;
};

// A place in a grid: texels from its tile's first own one on, cells of its tiles in the slices beside it, below 0 where they do not exist,
// and what slices weigh.
struct ColorPlace {
    vec2 inTile;
    vec4 cells;
    vec4 weights;
};

// The first of the slices that a depth is interpolated between.
float firstSlice(float at) {
#if SLICE_TAPS == 4
    return clamp(floor(at) - 1.0, 0.0, float(COLOR_SLICES - 4));
#elif SLICE_TAPS == 2
    return clamp(floor(at), 0.0, float(COLOR_SLICES - 2));
#else
    return 0.0;
#endif
}

// Lagrange's polynomials, at so many slices after the first.
vec4 sliceWeights(float t0) {
#if SLICE_TAPS == 4
    float t1 = t0 - 1.0;
    float t2 = t0 - 2.0;
    float t3 = t0 - 3.0;
    return vec4(-t1 * t2 * t3 / 6.0, t0 * t2 * t3 / 2.0, -t0 * t1 * t3 / 2.0, t0 * t1 * t2 / 6.0);
#elif SLICE_TAPS == 2
    return vec4(1.0 - t0, t0, 0.0, 0.0);
#else
    return vec4(1.0, 0.0, 0.0, 0.0);
#endif
}

// xy: u and v, or what stands in for them; what lies beyond all tiles is looked up at their edge.
ColorPlace colorPlace(vec2 xy, float w, ColorGrid grid) {
    vec2 texel = clamp((xy - grid.first) * grid.perUnit, vec2(COLOR_TILE_SIDE), COLOR_TILE_SIDE * (grid.tiles - 1.0) - 0.01);
    vec2 tile = floor(texel * (1.0 / COLOR_TILE_SIDE));
    float at = max(-w, 0.0) * colorSlicesPerUnit;
    float first = firstSlice(at);
    // The nearest texel: software renderers take longer to fetch one by its number.
    vec3 listed = vec3((tile + 0.5) * perColorTiles, grid.slice + first);
    vec4 cells = vec4(textureLod(colorTiles, listed, 0.0).rg, 1.0, 1.0);
#if SLICE_TAPS == 4
    cells.zw = textureLod(colorTiles, listed + vec3(0.0, 0.0, 2.0), 0.0).rg;
#elif SLICE_TAPS == 1
    cells.y = 1.0;
#endif
    return ColorPlace(texel - tile * COLOR_TILE_SIDE, cells - 1.0, sliceWeights(at - first));
}

bool isMissing(ColorPlace place) {
    return any(lessThan(place.cells, vec4(0.0)));
}

// Texels before a cell, and its layer. In floats: whole numbers below 2^24 are exact, and software renderers divide integers one by one.
vec3 cellCorner(float cell) {
    float row = floor((cell + 0.5) * (1.0 / CELLS_ACROSS));
    float layer = floor((row + 0.5) * (1.0 / CELLS_ACROSS));
    return vec3(CELL_SIDE * vec2(cell - row * CELLS_ACROSS, row - layer * CELLS_ACROSS), layer);
}

vec3 rootAt(vec2 texel, float layer) {
    return textureLod(colorTexels, vec3(texel * (1.0 / COLOR_LAYER_SIDE), layer), 0.0).rgb;
}

// X, Y, Z before the level's scale, by straight lines between coefficients: a look-up a slice. Below nothing where all is dark.
vec3 linearXyz(vec2 xy, float w, ColorGrid grid) {
    ColorPlace place = colorPlace(xy, w, grid);
    if (isMissing(place)) {
        return vec3(MISSING);
    }
    // A tile begins a texel before its own, and a texel's middle is half a texel on.
    vec2 inCell = round(place.inTile * GRAINS) / GRAINS + 1.5;
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < SLICE_TAPS; ++i) {
        vec3 corner = cellCorner(place.cells[i]);
        vec3 root = rootAt(inCell + corner.xy, corner.z);
        xyz += place.weights[i] * (root * root);
    }
    return xyz;
}

// As much by cubic B-splines: four bilinear look-ups a slice (C. Sigg and M. Hadwiger, "Fast third-order texture filtering", GPU Gems 2,
// chapter 20).
vec3 cubicXyz(vec2 xy, float w, ColorGrid grid) {
    ColorPlace place = colorPlace(xy, w, grid);
    if (isMissing(place)) {
        return vec3(MISSING);
    }
    vec2 below = floor(place.inTile);
    vec2 t = place.inTile - below;
    vec2 s = 1.0 - t;
    vec2 w0 = s * s * s / 6.0;
    vec2 w1 = 2.0 / 3.0 - 0.5 * t * t * (2.0 - t);
    vec2 w3 = t * t * t / 6.0;
    vec2 low = w0 + w1;
    // Of the first two coefficients along either axis, and of the other two.
    vec4 corners = vec4(below - 0.5 + w1 / low, below + 1.5 + w3 / (1.0 - low));
    corners = round(corners * GRAINS) / GRAINS + 1.0;
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < SLICE_TAPS; ++i) {
        vec3 corner = cellCorner(place.cells[i]);
        vec4 texels = corners + corner.xyxy;
        vec3 lowRow = mix(rootAt(texels.zy, corner.z), rootAt(texels.xy, corner.z), low.x);
        vec3 highRow = mix(rootAt(texels.zw, corner.z), rootAt(texels.xw, corner.z), low.x);
        vec3 root = mix(highRow, lowRow, low.y);
        xyz += place.weights[i] * (root * root);
    }
    return xyz;
}
