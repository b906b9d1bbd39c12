#include "include/average.glsl"
#include "include/expansion.glsl"
#include "include/window.glsl"

// Expansion terms times a Gaussian neighborhood of DFT bins, at one wavelength (thesis algorithm 3.3).

// RADIUS: tableRadius as a constant. ANCHOR: rounding of a frequency to the central bin, ANCHOR_FLOOR or ANCHOR_NEAREST. FEW_BINS: 1 to
// unroll the loops over bins. TERMS: see include/expansion.glsl.

// DFT bins of the terms T_n, one layer each, (real, imaginary); texel (0, 0) is bin tableFirst.
uniform sampler2DArray tableTerms;
uniform ivec2 tableFirst;
// On each side of the central bin.
uniform ivec2 tableRadius;
// Bins per cycle per meter along x and y, which is the patch's period in meters.
uniform vec2 tablePeriod;
// Rounding error of tablePeriod in float32, for the application, which finds a direction's bin in double precision.
uniform vec2 tablePeriodRest;

// Length of the innermost loops, over a bin's terms: compilers unroll short loops of constant length. These loops must be unrolled, since
// drivers limit iterations (include/loops.glsl).
const int WRITTEN_OUT = 16;

float[TERMS] coefficientsAt(float zeta) {
    float coefficients[TERMS];
    float coefficient = firstCoefficient(zeta);
    for (int block = 0; block < TERMS; block += WRITTEN_OUT) {
        for (int i = 0; i < WRITTEN_OUT; ++i) {
            if (block + i < TERMS) {
                coefficients[block + i] = coefficient;
                coefficient = nextCoefficient(coefficient, block + i + 1, zeta);
            }
        }
    }
    return coefficients;
}

vec2 binAmplitude(ivec2 texel, float coefficients[TERMS]) {
    vec2 amplitude = vec2(0.0);
    for (int block = 0; block < TERMS; block += WRITTEN_OUT) {
        for (int i = 0; i < WRITTEN_OUT; ++i) {
            if (block + i < TERMS) {
                amplitude += coefficients[block + i] * texelFetch(tableTerms, ivec3(texel, block + i), 0).rg;
            }
        }
    }
    return amplitude;
}

// |F_j|^2; 0 beyond the table, which contains all visible frequencies.
float binPower(ivec2 texel, float zeta) {
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(tableTerms, 0).xy))) {
        return 0.0;
    }
    return squaredMagnitude(binAmplitude(texel, coefficientsAt(zeta)));
}

// A frequency among the bins: the central bin of its neighborhood, and the offset from the frequency to that bin, in bins.
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

struct Powers {
    // Square of the sum of amplitudes: one coherence area.
    float coherent;
    // Sum of the amplitudes' squares: Stam's angle brackets (in the spirit of thesis eq. 2.57).
    float ensemble;
};

Powers powersOfBins(vec3 uvw, float wavelength) {
    Anchored middle = anchored(uvw.xy, wavelength);
    float coefficients[TERMS] = coefficientsAt(expansionPhase(uvw.z, wavelength));
    vec2 amplitude = vec2(0.0);
    float squares = 0.0;
    for (int j = -tableRadius.y; j <= tableRadius.y; ++j) {
        float weightY = windowAmplitude(middle.offset.y + float(j), windowSigmaBins.y);
        for (int i = -tableRadius.x; i <= tableRadius.x; ++i) {
            float weight = weightY * windowAmplitude(middle.offset.x + float(i), windowSigmaBins.x);
            vec2 bin = weight * binAmplitude(middle.bin - tableFirst + ivec2(i, j), coefficients);
            amplitude += bin;
            squares += dot(bin, bin);
        }
    }
    return Powers(squaredMagnitude(amplitude), squares);
}

#ifdef SPECTRAL
// Powers at the fragment's (u, v, w) and wavelength, computed once: a shader that needs both averages cannot compute two sums within the
// driver's limit of iterations (include/loops.glsl).
bool binsAreSummed = false;
Powers summedBins;

Powers bothPowers(vec3 uvw, float wavelength) {
    if (!binsAreSummed) {
        summedBins = powersOfBins(uvw, wavelength);
        binsAreSummed = true;
    }
    return summedBins;
}
#else
#define bothPowers powersOfBins
#endif

#if FEW_BINS
const ivec2 SIDE = 2 * RADIUS + 1;

// Coherent power with the loop over terms outside and the loops over bins unrolled, as in the thesis (algorithm 3.3).
float coherentPower(vec3 uvw, float wavelength) {
    Anchored middle = anchored(uvw.xy, wavelength);
    ivec2 corner = middle.bin - RADIUS - tableFirst;
    vec2 offset = middle.offset - vec2(RADIUS);
    float weightsX[SIDE.x];
    float weightsY[SIDE.y];
    for (int i = 0; i < SIDE.x; ++i) {
        weightsX[i] = windowAmplitude(offset.x + float(i), windowSigmaBins.x);
    }
    for (int j = 0; j < SIDE.y; ++j) {
        weightsY[j] = windowAmplitude(offset.y + float(j), windowSigmaBins.y);
    }
    float zeta = expansionPhase(uvw.z, wavelength);
    float coefficient = firstCoefficient(zeta);
    vec2 amplitude = vec2(0.0);
    for (int n = 0; n < TERMS; ++n) {
        vec2 term = vec2(0.0);
        for (int j = 0; j < SIDE.y; ++j) {
            vec2 row = vec2(0.0);
            for (int i = 0; i < SIDE.x; ++i) {
                row += weightsX[i] * texelFetch(tableTerms, ivec3(corner + ivec2(i, j), n), 0).rg;
            }
            term += weightsY[j] * row;
        }
        amplitude += coefficient * term;
        coefficient = nextCoefficient(coefficient, n + 1, zeta);
    }
    return squaredMagnitude(amplitude);
}
#else
float coherentPower(vec3 uvw, float wavelength) {
    return bothPowers(uvw, wavelength).coherent;
}
#endif

float ensemblePower(vec3 uvw, float wavelength) {
    return bothPowers(uvw, wavelength).ensemble;
}
