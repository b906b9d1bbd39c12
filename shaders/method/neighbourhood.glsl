#include "include/average.glsl"
#include "include/expansion.glsl"
#include "include/window.glsl"

// Expansion terms times a Gaussian neighbourhood of DFT bins, at one wavelength (thesis algorithm 3.3).

// DFT bins of the terms T_n, one layer each, (real, imaginary); texel (0, 0) is bin tableFirst.
uniform sampler2DArray tableTerms;
uniform ivec2 tableFirst;
// Number of bins per unit of frequency, which is the patch's period in metres.
uniform vec2 tablePeriod;
// What float32 leaves of it; for those who find a bin in double precision.
uniform vec2 tablePeriodRest;

#if !MANY_BINS

const ivec2 SIDE = 2 * RADIUS + 1;

struct Neighbourhood {
    ivec2 corner;
    float weightsX[SIDE.x];
    float weightsY[SIDE.y];
};

#endif

// A frequency among the bins: the one in the middle of its neighbourhood, and how far that lies from it.
struct Anchored {
    ivec2 bin;
    vec2 offset;
};

Anchored anchored(vec2 uv, float wavelength) {
#ifdef SPECTRAL
    ivec2 nearest = ivec2(exactBin.xy);
    vec2 rest = exactBin.zw;
#else
    vec2 position = uv / wavelength * tablePeriod;
    ivec2 nearest = ivec2(floor(position + 0.5));
    vec2 rest = position - vec2(nearest);
#endif
#if ANCHOR == ANCHOR_FLOOR
    ivec2 below = ivec2(lessThan(rest, vec2(0.0)));
    return Anchored(nearest - below, -vec2(below) - rest);
#else
    return Anchored(nearest, -rest);
#endif
}

#if !MANY_BINS

Neighbourhood neighbourhoodOf(vec2 uv, float wavelength) {
    Anchored middle = anchored(uv, wavelength);
    Neighbourhood result;
    result.corner = middle.bin - RADIUS - tableFirst;
    vec2 offset = middle.offset - vec2(RADIUS);
    for (int i = 0; i < SIDE.x; ++i) {
        result.weightsX[i] = windowAmplitude(offset.x + float(i), windowSigmaBins.x);
    }
    for (int j = 0; j < SIDE.y; ++j) {
        result.weightsY[j] = windowAmplitude(offset.y + float(j), windowSigmaBins.y);
    }
    return result;
}

#endif

// Compilers write out loops of few steps that they know; those of a wavelength's terms are the innermost and must not be
// loops (loops.glsl).
const int WRITTEN_OUT = 16;

// |F_j|^2 of the bin at a texel; 0 beyond the table, which holds all that can be seen.
float binPower(ivec2 texel, float zeta) {
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(tableTerms, 0).xy))) {
        return 0.0;
    }
    float coefficient = firstCoefficient(zeta);
    vec2 amplitude = vec2(0.0);
    for (int block = 0; block < TERMS; block += WRITTEN_OUT) {
        for (int i = 0; i < WRITTEN_OUT; ++i) {
            int n = block + i;
            if (n < TERMS) {
                amplitude += coefficient * texelFetch(tableTerms, ivec3(texel, n), 0).rg;
                coefficient = nextCoefficient(coefficient, n + 1, zeta);
            }
        }
    }
    return squaredMagnitude(amplitude);
}

#if MANY_BINS

// Many bins: loops of a length that compilers do not know, lest they write each out.
uniform ivec2 tableRadius;

vec2 manyBins(vec3 uvw, float wavelength) {
    Anchored middle = anchored(uvw.xy, wavelength);
    ivec2 nearest = middle.bin;
    vec2 offset = middle.offset;
    float zeta = expansionPhase(uvw.z, wavelength);
    float coefficients[TERMS];
    float coefficient = firstCoefficient(zeta);
    for (int n = 0; n < TERMS; ++n) {
        coefficients[n] = coefficient;
        coefficient = nextCoefficient(coefficient, n + 1, zeta);
    }
    vec2 sum = vec2(0.0);
    float squares = 0.0;
    for (int j = -tableRadius.y; j <= tableRadius.y; ++j) {
        float weightY = windowAmplitude(offset.y + float(j), windowSigmaBins.y);
        vec2 row = vec2(0.0);
        float rowSquares = 0.0;
        for (int i = -tableRadius.x; i <= tableRadius.x; ++i) {
            float weight = windowAmplitude(offset.x + float(i), windowSigmaBins.x);
            ivec2 texel = nearest - tableFirst + ivec2(i, j);
            vec2 bin = vec2(0.0);
            for (int block = 0; block < TERMS; block += WRITTEN_OUT) {
                for (int k = 0; k < WRITTEN_OUT; ++k) {
                    if (block + k < TERMS) {
                        bin += coefficients[block + k] * texelFetch(tableTerms, ivec3(texel, block + k), 0).rg;
                    }
                }
            }
            row += weight * bin;
            rowSquares += weight * weight * dot(bin, bin);
        }
        sum += weightY * row;
        squares += weightY * weightY * rowSquares;
    }
    return vec2(squaredMagnitude(sum), squares);
}

#ifdef SPECTRAL
// A shader that asks for both averages of one wavelength sums once: so many steps are not had twice (loops.glsl).
bool binsAreSummed = false;
vec2 summedBins;

vec2 bothPowers(vec3 uvw, float wavelength) {
    if (!binsAreSummed) {
        summedBins = manyBins(uvw, wavelength);
        binsAreSummed = true;
    }
    return summedBins;
}
#else
#define bothPowers manyBins
#endif

float coherentPower(vec3 uvw, float wavelength) {
    return bothPowers(uvw, wavelength).x;
}

float ensemblePower(vec3 uvw, float wavelength) {
    return bothPowers(uvw, wavelength).y;
}

#else

// Amplitudes of the taps first, square last: one coherence area.
float coherentPower(vec3 uvw, float wavelength) {
    Neighbourhood taps = neighbourhoodOf(uvw.xy, wavelength);
    float zeta = expansionPhase(uvw.z, wavelength);
    float coefficient = firstCoefficient(zeta);
    vec2 amplitude = vec2(0.0);
    for (int n = 0; n < TERMS; ++n) {
        vec2 term = vec2(0.0);
        for (int j = 0; j < SIDE.y; ++j) {
            vec2 row = vec2(0.0);
            for (int i = 0; i < SIDE.x; ++i) {
                row += taps.weightsX[i] * texelFetch(tableTerms, ivec3(taps.corner + ivec2(i, j), n), 0).rg;
            }
            term += taps.weightsY[j] * row;
        }
        amplitude += coefficient * term;
        coefficient = nextCoefficient(coefficient, n + 1, zeta);
    }
    return squaredMagnitude(amplitude);
}

// Squares of the taps, then their sum: Stam's angle brackets (thesis eq. 2.29 in spirit).
float ensemblePower(vec3 uvw, float wavelength) {
    Neighbourhood taps = neighbourhoodOf(uvw.xy, wavelength);
    float zeta = expansionPhase(uvw.z, wavelength);
    float power = 0.0;
    for (int j = 0; j < SIDE.y; ++j) {
        for (int i = 0; i < SIDE.x; ++i) {
            float weight = taps.weightsX[i] * taps.weightsY[j];
            power += weight * weight * binPower(taps.corner + ivec2(i, j), zeta);
        }
    }
    return power;
}

#endif
