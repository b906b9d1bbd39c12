#include "include/average.glsl"
#include "include/expansion.glsl"

// Interpolation of spectra that were windowed and resampled beforehand (sunbeam.precompute.spectrum).

// KERNEL_AT_PLACE: expression for the weights of the TAPS taps by place, the position between two samples from -1 to 1: polynomials without
// a loop, since drivers limit iterations (include/loops.glsl).

// The taps around a position along one axis of a grid: index of the first, and weights.
struct Taps {
    int first;
    float weights[TAPS];
};

// position: in samples from frequency 0, where float32 is finest and the brightest order has its flanks; origin: position of the grid's
// first sample.
Taps tapsAround(float position, float origin) {
    float edge = position - 0.5 * float(TAPS);
    float below = floor(edge);
    Taps taps;
    taps.first = int(below) - int(origin) + 1;
    float place = 2.0 * (edge - below) - 1.0;
    taps.weights = KERNEL_AT_PLACE;
    return taps;
}

// Position in a grid: on one of its columns, interpolated only along the column, or between columns, interpolated along both axes. A column
// is stored as a row of texels.
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

// Layout of the terms of one spectrum (sunbeam.precompute.plan.GridSampling.TermsLayout): texels is the number of texels per frequency, of
// which together lie side by side in a row, the others in further layers.
struct Terms {
    int texels;
    int together;
    int firstLayer;
};

// Weighted sum of the taps along a row of texels.
vec4 rowTexel(sampler2DArray grid, Terms terms, int texel, Taps along, int row) {
    int first = along.first * terms.together + texel % terms.together;
    int layer = terms.firstLayer + texel / terms.together;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < TAPS; ++i) {
        sum += along.weights[i] * texelFetch(grid, ivec3(first + i * terms.together, row, layer), 0);
    }
    return sum;
}

vec4 texelAt(sampler2DArray grid, Terms terms, int texel, Place place) {
    if (place.onColumn) {
        return rowTexel(grid, terms, texel, place.y, place.column);
    }
    vec4 sum = vec4(0.0);
    for (int j = 0; j < TAPS; ++j) {
        sum += place.y.weights[j] * rowTexel(grid, terms, texel, place.x, place.y.first + j);
    }
    return sum;
}

vec2 twoTerms(vec4 two, vec2 coefficients) {
    return coefficients.x * two.xy + coefficients.y * two.zw;
}

// Sum of complex terms, two per texel, times their coefficients, four per texel.
vec2 amplitudeAt(
        sampler2DArray grid, Terms terms, Place place, sampler2D coefficients, vec2 phaseMap, float zeta) {
    int rows = (terms.texels + 1) / 2;
    PhaseSamples samples = samplesAround(coefficients, phaseMap, zeta);
    vec2 amplitude = vec2(0.0);
    for (int row = 0; row < rows; ++row) {
        vec4 four = sampledCoefficients(coefficients, samples, row);
        amplitude += twoTerms(texelAt(grid, terms, 2 * row, place), four.xy);
        if (2 * row + 1 < terms.texels) {
            amplitude += twoTerms(texelAt(grid, terms, 2 * row + 1, place), four.zw);
        }
    }
    return amplitude;
}

// Sum of real terms, four per texel, times their coefficients.
float realSumAt(
        sampler2DArray grid, Terms terms, Place place, sampler2D coefficients, vec2 phaseMap, float zeta) {
    PhaseSamples samples = samplesAround(coefficients, phaseMap, zeta);
    float sum = 0.0;
    for (int texel = 0; texel < terms.texels; ++texel) {
        vec4 four = sampledCoefficients(coefficients, samples, texel);
        sum += dot(four, texelAt(grid, terms, texel, place));
    }
    return sum;
}
