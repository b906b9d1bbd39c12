#include "include/constants.glsl"
#include "include/expansion.glsl"
#include "include/wavelengths.glsl"
#ifndef PERIOD_RING
#include "method/grid_tables.glsl"
#endif

// The patch repeated Q times along x and along y, evenly lit, with sharp edges instead of the Gaussian window: the spectrum
// of one period, interpolated, times the array factor of its replicas (thesis section 2.4.1, eq. 2.62).

// PERIOD_RING: set for the thesis's interpolation, a sinc over a bin and the ring of its eight neighbors.

// Samples of one period's spectrum, two complex terms per texel; PERIOD_LAYERS layers. Then the terms' coefficients, and offset and scale
// from the phase zeta to a sample of these (include/expansion.glsl).
uniform sampler2DArray periodTerms;
uniform sampler2D periodCoefficients;
uniform vec2 periodPhaseMap;
// Samples per cycle per meter, and index of the first sample, along x and y.
uniform vec2 periodScale;
uniform vec2 periodFirst;
// The period in meters, and Q, along x and y.
uniform vec2 periodLength;
uniform vec2 periodReplicas;

// |sin(Q pi turns) / (Q sin(pi turns))| with Q replicas; 1 if turns, the frequency in cycles per period, is an integer, where both sines
// vanish. The thesis writes w T / 2 for pi turns.
float arrayFactor(float turns, float replicas) {
    // The factor has period 1; subtracting whole turns leaves float32 more digits.
    float angle = PI * (turns - floor(turns + 0.5));
    float replicasAngle = replicas * angle;
    // The next term of the series is replicasAngle^4 / 120, 1e-10 of the factor.
    if (abs(replicasAngle) < 0.01) {
        return 1.0 - (replicasAngle * replicasAngle - angle * angle) / 6.0;
    }
    return abs(sin(replicasAngle) / (replicas * sin(angle)));
}

#ifdef PERIOD_RING
// The thesis's interpolation: the sum of the bin below and its eight neighbors, each times a sinc of its distance.
vec2 periodAmplitude(vec2 frequency, float zeta) {
    vec2 position = frequency * periodScale;
    vec2 below = floor(position);
    PhaseSamples samples = samplesAround(periodCoefficients, periodPhaseMap, zeta);
    vec2 amplitude = vec2(0.0);
    for (int layer = 0; layer < PERIOD_LAYERS; ++layer) {
        vec4 terms = vec4(0.0);
        for (int i = 0; i < 9; ++i) {
            vec2 bin = below + vec2(i % 3 - 1, i / 3 - 1);
            float angle = PI * max(distance(position, bin), 1e-6);
            terms += sin(angle) / angle * texelFetch(periodTerms, ivec3(bin - periodFirst, layer), 0);
        }
        vec4 four = sampledCoefficients(periodCoefficients, samples, layer / 2);
        vec2 two = layer % 2 == 0 ? four.xy : four.zw;
        amplitude += two.x * terms.xy + two.y * terms.zw;
    }
    return amplitude;
}
#else
vec2 periodAmplitude(vec2 frequency, float zeta) {
    Place place = inGrid(frequency * periodScale, periodFirst);
    Terms terms = Terms(PERIOD_LAYERS, 1, 0);
    return amplitudeAt(periodTerms, terms, place, periodCoefficients, periodPhaseMap, zeta);
}
#endif

float coherentPower(vec3 uvw, float wavelength) {
    vec2 frequency = uvw.xy / wavelength;
    vec2 turns = frequency * periodLength;
    float factor = arrayFactor(turns.x, periodReplicas.x) * arrayFactor(turns.y, periodReplicas.y);
    return factor * factor * squaredMagnitude(periodAmplitude(frequency, expansionPhase(uvw.z, wavelength)));
}

// The replicas have fixed positions, so both averages are the same.
float ensemblePower(vec3 uvw, float wavelength) {
    return coherentPower(uvw, wavelength);
}

vec3 diffractedXyz(vec3 uvw) {
    return fixedWavelengthsXyz(uvw);
}
