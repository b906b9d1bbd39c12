#include "include/average.glsl"
#include "include/expansion.glsl"

// Spectra that were windowed and resampled beforehand (sunbeam.precompute.resample), and how they are interpolated.

// Weights of the TAPS taps by the fraction of the position between two samples; four taps a texel, rows of texels.
uniform sampler2D gridKernel;

const int KERNEL_ROWS = (TAPS + 3) / 4;

// The taps around a position along one axis of a grid.
struct Taps {
    int first;
    float weights[TAPS];
};

// position: in samples, 0 at frequency 0, where float32 is finest and the brightest order has its skirts; origin: the grid's
// first sample.
Taps tapsAround(float position, float origin) {
    float edge = position - 0.5 * float(TAPS);
    float below = floor(edge);
    Taps taps;
    taps.first = int(below) - int(origin) + 1;
    float place = (edge - below) * float(textureSize(gridKernel, 0).x - 1);
    for (int row = 0; row < KERNEL_ROWS; ++row) {
        vec4 four = betweenTexels(gridKernel, place, row);
        for (int i = 0; i < 4 && 4 * row + i < TAPS; ++i) {
            taps.weights[4 * row + i] = four[i];
        }
    }
    return taps;
}

// Where a grid is looked at: on one of its columns, interpolated along y only, or anywhere, along both axes. Columns are rows
// of texels: neighbouring pixels share them.
struct Place {
    bool onColumn;
    int column;
    Taps x;
    Taps y;
};

Place onColumn(int column, float y, float origin) {
    Taps taps = tapsAround(y, origin);
    return Place(true, column, taps, taps);
}

// position: in samples from frequency 0.
Place inGrid(vec2 position, vec2 origin) {
    return Place(false, 0, tapsAround(position.x, origin.x), tapsAround(position.y, origin.y));
}

// Taps that lie beside each other in a row of texels.
vec4 rowTexel(sampler2DArray grid, int layer, Taps along, int row) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < TAPS; ++i) {
        sum += along.weights[i] * texelFetch(grid, ivec3(along.first + i, row, layer), 0);
    }
    return sum;
}

vec4 texelAt(sampler2DArray grid, int layer, Place place) {
    if (place.onColumn) {
        return rowTexel(grid, layer, place.y, place.column);
    }
    vec4 sum = vec4(0.0);
    for (int j = 0; j < TAPS; ++j) {
        sum += place.y.weights[j] * rowTexel(grid, layer, place.x, place.y.first + j);
    }
    return sum;
}

vec2 twoTerms(vec4 terms, vec2 coefficients) {
    return coefficients.x * terms.xy + coefficients.y * terms.zw;
}

// Sum of complex terms, two a texel, times their coefficients, four a texel.
vec2 amplitudeAt(
        sampler2DArray grid, int firstLayer, int layers, Place place, sampler2D coefficients, vec2 phaseMap, float zeta) {
    int rows = (layers + 1) / 2;
    vec2 amplitude = vec2(0.0);
    for (int row = 0; row < rows; ++row) {
        vec4 four = sampledCoefficients(coefficients, phaseMap, zeta, row, rows);
        amplitude += twoTerms(texelAt(grid, firstLayer + 2 * row, place), four.xy);
        if (2 * row + 1 < layers) {
            amplitude += twoTerms(texelAt(grid, firstLayer + 2 * row + 1, place), four.zw);
        }
    }
    return amplitude;
}

// Sum of real terms, four a texel, times their coefficients.
float realSumAt(
        sampler2DArray grid, int firstLayer, int layers, Place place, sampler2D coefficients, vec2 phaseMap, float zeta) {
    float sum = 0.0;
    for (int layer = 0; layer < layers; ++layer) {
        vec4 four = sampledCoefficients(coefficients, phaseMap, zeta, layer, layers);
        sum += dot(four, texelAt(grid, firstLayer + layer, place));
    }
    return sum;
}
