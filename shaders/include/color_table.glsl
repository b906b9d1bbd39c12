// Look-ups in color tables (in double precision: AtlasPages.TableLookUp). Within a tile of (u, v) a filter interpolates
// the square roots of X, Y and Z; Lagrange's polynomial through SLICE_TAPS slices interpolates along w.

// COLOR_SLICES: slices in w, 1 for a table of one light; COLOR_TILE_SIDE, COLOR_LAYER_SIDE: texels along the side of a tile and of an atlas
// layer; COLOR_FILTER: the function of Interpolation.shaderFunction.

// Atlas of the filters' coefficients. A page holds a tile with a border along both axes: one texel before the tile, two after it.
uniform sampler2DArray colorTexels;
// Page table: red is the number of a tile's page plus one, 0 if the tile is not resident; green is the same for the next slice. Layers are
// the slices of level 0, then of level 1, ...
uniform sampler2DArray colorTiles;
// One over the size of the page table in tiles.
uniform vec2 perColorTiles;
// Slices per unit of |w|; the first is at 0.
uniform float colorSlicesPerUnit;

#ifndef SLICE_TAPS
#if COLOR_SLICES == 1
#define SLICE_TAPS 1
#else
#define SLICE_TAPS 4
#endif
#endif

// Positions are rounded to this fraction of a texel. Then adding a page's position is exact, so that a color does not depend on its tile's
// page. (Sides of layers are powers of two.)
const float SUBTEXEL_STEPS = 8192.0;
const float PAGE_SIDE = COLOR_TILE_SIDE + 3.0;
const float PAGES_ACROSS = floor(COLOR_LAYER_SIDE / PAGE_SIDE);

// Marks a missing color: X, Y and Z where a tile is not resident. Far above any color.
const float MISSING = 1e30;

// Grid of a level: table coordinates of its first coefficient, coefficients per unit, tiles across and down, and its first layer in the
// page table. Table coordinates are u and v, or those of one light's directions (method/table.glsl).
struct ColorGrid {
    vec2 first;
    float perUnit;
    vec2 tiles;
    float slice;
};

// Position in a grid: inTile counts texels from the first one of its tile, without border; pages are the numbers of the tile's pages in up
// to four slices, -1 where the tile is not resident; weights are those of the slices.
struct ColorPlace {
    vec2 inTile;
    vec4 pages;
    vec4 weights;
};

// Index of the first slice that an interpolation along w reads; at: position along w, in slices.
float firstSlice(float at) {
#if SLICE_TAPS == 4
    return clamp(floor(at) - 1.0, 0.0, float(COLOR_SLICES - 4));
#elif SLICE_TAPS == 2
    return clamp(floor(at), 0.0, float(COLOR_SLICES - 2));
#else
    return 0.0;
#endif
}

// Weights of the slices by Lagrange's polynomials; t0: distance from the first slice, in slices.
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

// xy: table coordinates, clamped to the grid.
ColorPlace colorPlace(vec2 xy, float w, ColorGrid grid) {
    vec2 texel = clamp((xy - grid.first) * grid.perUnit, vec2(COLOR_TILE_SIDE), COLOR_TILE_SIDE * (grid.tiles - 1.0) - 0.01);
    vec2 tile = floor(texel * (1.0 / COLOR_TILE_SIDE));
    float at = max(-w, 0.0) * colorSlicesPerUnit;
    float first = firstSlice(at);
    // Nearest sampling: texelFetch is slower on software renderers.
    vec3 entry = vec3((tile + 0.5) * perColorTiles, grid.slice + first);
    vec4 pages = vec4(textureLod(colorTiles, entry, 0.0).rg, 1.0, 1.0);
#if SLICE_TAPS == 4
    pages.zw = textureLod(colorTiles, entry + vec3(0.0, 0.0, 2.0), 0.0).rg;
#elif SLICE_TAPS == 1
    pages.y = 1.0;
#endif
    return ColorPlace(texel - tile * COLOR_TILE_SIDE, pages - 1.0, sliceWeights(at - first));
}

bool isMissing(ColorPlace place) {
    return any(lessThan(place.pages, vec4(0.0)));
}

// Corner of a page in texels, and its layer. Computed in floats, in which integers below 2^24 are exact, since software renderers do not
// vectorize integer division.
vec3 pageCorner(float page) {
    float row = floor((page + 0.5) * (1.0 / PAGES_ACROSS));
    float layer = floor((row + 0.5) * (1.0 / PAGES_ACROSS));
    return vec3(PAGE_SIDE * vec2(page - row * PAGES_ACROSS, row - layer * PAGES_ACROSS), layer);
}

vec3 rootAt(vec2 texel, float layer) {
    return textureLod(colorTexels, vec3(texel * (1.0 / COLOR_LAYER_SIDE), layer), 0.0).rgb;
}

// X, Y, Z before the level's scale, linear between coefficients: one bilinear fetch per slice. May be slightly negative in the dark.
vec3 linearXyz(vec2 xy, float w, ColorGrid grid) {
    ColorPlace place = colorPlace(xy, w, grid);
    if (isMissing(place)) {
        return vec3(MISSING);
    }
    // 1.5: one texel of border, and half a texel from a texel's corner to its center.
    vec2 inPage = round(place.inTile * SUBTEXEL_STEPS) / SUBTEXEL_STEPS + 1.5;
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < SLICE_TAPS; ++i) {
        vec3 corner = pageCorner(place.pages[i]);
        vec3 root = rootAt(inPage + corner.xy, corner.z);
        xyz += place.weights[i] * (root * root);
    }
    return xyz;
}

// X, Y, Z before the level's scale, by cubic B-splines: four bilinear fetches per slice (C. Sigg and M. Hadwiger, "Fast third-order texture
// filtering", GPU Gems 2, chapter 20).
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
    // Along either axis the positions of two bilinear fetches: xy between the first two coefficients, zw between the other two.
    vec4 corners = vec4(below - 0.5 + w1 / low, below + 1.5 + w3 / (1.0 - low));
    corners = round(corners * SUBTEXEL_STEPS) / SUBTEXEL_STEPS + 1.0;
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < SLICE_TAPS; ++i) {
        vec3 corner = pageCorner(place.pages[i]);
        vec4 texels = corners + corner.xyxy;
        vec3 lowRow = mix(rootAt(texels.zy, corner.z), rootAt(texels.xy, corner.z), low.x);
        vec3 highRow = mix(rootAt(texels.zw, corner.z), rootAt(texels.xw, corner.z), low.x);
        vec3 root = mix(highRow, lowRow, low.y);
        xyz += place.weights[i] * (root * root);
    }
    return xyz;
}
