// Spectra that were windowed and resampled beforehand (sunbeam.precompute.resample), and how they are interpolated.

// Weights of the TAPS taps by the fraction of the position between two samples; four taps a texel, rows of texels.
uniform sampler2D gridKernel;

const int KERNEL_ROWS = (TAPS + 3) / 4;
const float KERNEL_SAMPLES = 1024.0;

// The taps around a position along one axis of a grid.
struct Taps {
    int first;
    float weights[TAPS];
};

// position: in samples of the grid, 0 at its first sample.
Taps tapsAround(float position) {
    float edge = position - 0.5 * float(TAPS);
    float below = floor(edge);
    Taps taps;
    taps.first = int(below) + 1;
    float at = (0.5 + (edge - below) * (KERNEL_SAMPLES - 1.0)) / KERNEL_SAMPLES;
    for (int row = 0; row < KERNEL_ROWS; ++row) {
        vec4 four = texture(gridKernel, vec2(at, (float(row) + 0.5) / float(KERNEL_ROWS)));
        for (int i = 0; i < 4 && 4 * row + i < TAPS; ++i) {
            taps.weights[4 * row + i] = four[i];
        }
    }
    return taps;
}

// Interpolated along y only.
vec4 onColumn(sampler2DArray grid, int layer, int column, Taps y) {
    vec4 sum = vec4(0.0);
    for (int j = 0; j < TAPS; ++j) {
        sum += y.weights[j] * texelFetch(grid, ivec3(column, y.first + j, layer), 0);
    }
    return sum;
}

// Interpolated along both axes.
vec4 atPoint(sampler2DArray grid, int layer, Taps x, Taps y) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < TAPS; ++i) {
        sum += x.weights[i] * onColumn(grid, layer, x.first + i, y);
    }
    return sum;
}

// Four coefficients of the expansion a texel. phaseMap: offset and scale from zeta to the texture coordinate.
vec4 fourCoefficients(sampler2D coefficients, int row, int rows, vec2 phaseMap, float zeta) {
    return texture(coefficients, vec2(phaseMap.x + phaseMap.y * zeta, (float(row) + 0.5) / float(rows)));
}

#if COHERENT_LAYERS > 0
// Two complex terms a texel.
uniform sampler2DArray coherentPoint;
uniform sampler2DArray coherentRays;
uniform sampler2D coherentCoefficients;
uniform vec2 coherentPhaseMap;
// Samples per cycle per metre, and index of the first sample along x and y.
uniform float coherentScale;
uniform vec2 coherentPointFirst;

const int COHERENT_ROWS = (COHERENT_LAYERS + 1) / 2;

vec2 twoTerms(vec4 terms, vec2 coefficients) {
    return coefficients.x * terms.xy + coefficients.y * terms.zw;
}

float coherentPointPower(vec2 frequency, float zeta) {
    vec2 position = frequency * coherentScale - coherentPointFirst;
    Taps x = tapsAround(position.x);
    Taps y = tapsAround(position.y);
    vec2 amplitude = vec2(0.0);
    for (int row = 0; row < COHERENT_ROWS; ++row) {
        vec4 four = fourCoefficients(coherentCoefficients, row, COHERENT_ROWS, coherentPhaseMap, zeta);
        amplitude += twoTerms(atPoint(coherentPoint, 2 * row, x, y), four.xy);
        if (2 * row + 1 < COHERENT_LAYERS) {
            amplitude += twoTerms(atPoint(coherentPoint, 2 * row + 1, x, y), four.zw);
        }
    }
    return squaredMagnitude(amplitude);
}

float coherentRayPower(int firstLayer, int column, Taps taps, float zeta) {
    vec2 amplitude = vec2(0.0);
    for (int row = 0; row < COHERENT_ROWS; ++row) {
        vec4 four = fourCoefficients(coherentCoefficients, row, COHERENT_ROWS, coherentPhaseMap, zeta);
        amplitude += twoTerms(onColumn(coherentRays, firstLayer + 2 * row, column, taps), four.xy);
        if (2 * row + 1 < COHERENT_LAYERS) {
            amplitude += twoTerms(onColumn(coherentRays, firstLayer + 2 * row + 1, column, taps), four.zw);
        }
    }
    return squaredMagnitude(amplitude);
}
#endif

#if ENSEMBLE_LAYERS > 0
// Four real terms a texel.
uniform sampler2DArray ensemblePoint;
uniform sampler2DArray ensembleRays;
uniform sampler2D ensembleCoefficients;
uniform vec2 ensemblePhaseMap;
uniform float ensembleScale;
uniform vec2 ensemblePointFirst;

float ensemblePointPower(vec2 frequency, float zeta) {
    vec2 position = frequency * ensembleScale - ensemblePointFirst;
    Taps x = tapsAround(position.x);
    Taps y = tapsAround(position.y);
    float power = 0.0;
    for (int layer = 0; layer < ENSEMBLE_LAYERS; ++layer) {
        vec4 four = fourCoefficients(ensembleCoefficients, layer, ENSEMBLE_LAYERS, ensemblePhaseMap, zeta);
        power += dot(four, atPoint(ensemblePoint, layer, x, y));
    }
    return power;
}

float ensembleRayPower(int firstLayer, int column, Taps taps, float zeta) {
    float power = 0.0;
    for (int layer = 0; layer < ENSEMBLE_LAYERS; ++layer) {
        vec4 four = fourCoefficients(ensembleCoefficients, layer, ENSEMBLE_LAYERS, ensemblePhaseMap, zeta);
        power += dot(four, onColumn(ensembleRays, firstLayer + layer, column, taps));
    }
    return power;
}
#endif
