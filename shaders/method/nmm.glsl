#include "include/constants.glsl"
#include "include/spectrum.glsl"
#include "include/wavelengths.glsl"
#include "method/nmm_bins.glsl"

// Sums only the wavelengths at which the ray f = (u, v) / lambda meets a DFT bin (thesis section 3.5). There is one per order, weighted
// by the order's width.
//
// The ray f = s (u, v), s = 1 / lambda, has its least distance d from bin f_j at s_j = f_j . (u, v) / |(u, v)|^2; for a bin on the ray that
// is at lambda = L u / n. S is the light's spectrum, xbar a color matching function. With a Gaussian as the window's spectrum, and while
// |F_j| hardly changes, the order adds
//
//     int |F_j|^2 exp(-|s (u, v) - f_j|^2 / sigma_f^2) S xbar dlambda
//         = |F_j|^2 exp(-d^2 / sigma_f^2) W(s_j, sigma_f / |(u, v)|),
//     W(s_j, width) = int S xbar exp(-((1 / lambda - s_j) / width)^2) dlambda,
//
// and W of a narrow order is sqrt(pi) lambda_j^2 width S xbar(lambda_j): the order's width in wavelength, which the thesis leaves out. Near
// u = v = 0 orders are wider than the color matching functions; there all wavelengths are summed.

// ORDERS_OVERLAP: 1 if the window's spectrum spans several bins; ACROSS: number of bins read on each side of the ray.

// Table of W / width over 1 / lambda (columns) and width (rows); the maps give offset and scale from these to both texture coordinates.
uniform sampler2D orderWeights;
uniform vec2 orderPlaceMap;
uniform vec2 orderWidthMap;
// Largest width, in 1 / lambda and 1 / meter, of an order that is summed at one wavelength.
uniform float orderWidest;
// Standard deviation of the window's spectrum, cycles per meter.
uniform float windowSigmaFrequency;

// Overlapping orders of one coherence area interfere, so that no order has a power of its own.
const bool ORDERS_INTERFERE = ORDERS_OVERLAP == 1 && !ENSEMBLE;

vec3 orderWeight(float waveNumber, float width) {
    vec2 at = vec2(orderPlaceMap.x + orderPlaceMap.y * waveNumber, orderWidthMap.x + orderWidthMap.y * width);
    return width * texture(orderWeights, at).rgb;
}

// Wavelength of an order; one whose center lies just outside the band is clamped to its end.
float orderWavelength(float waveNumber) {
    return clamp(1.0 / waveNumber, SHORTEST_WAVELENGTH, LONGEST_WAVELENGTH);
}

// Sample where the ray crosses a column of bins, for orders that interfere. A sample represents all wavelengths up to halfway to its
// neighbors: its weight is W / (sqrt(pi) width) times the columns' distance in 1 / lambda, where sampleShare returns the factors beside W.
vec3 sampledColumn(vec3 uvw, float width, float waveNumber) {
    return orderWeight(waveNumber, width) * averagePower(uvw, orderWavelength(waveNumber));
}

// Factor by which samples on the columns alone overrate power, since they meet the bins' Gaussians at their maxima: on the average over the
// phases of the bins Poisson's sum 1 + 2 sum_k exp(-(pi k sigma)^2), sigma in bins. Four terms suffice from sigma = 0.2 on.
float overrated(float sigmaBins) {
    float sum = 1.0;
    for (int k = 1; k <= 4; ++k) {
        float turns = PI * float(k) * sigmaBins;
        sum += 2.0 * exp(-turns * turns);
    }
    return sum;
}

float sampleShare(float width, float waveNumberStep, float sigmaBins) {
    return waveNumberStep / (sqrt(PI) * width * overrated(sigmaBins));
}

vec3 separateOrders(vec3 uvw, float width, float waveNumber) {
    vec3 xyz = vec3(0.0);
    float squaredLength = dot(uvw.xy, uvw.xy);
    vec2 frequency = uvw.xy * waveNumber * tablePeriod;
    bool alongX = abs(uvw.x * tablePeriod.x) >= abs(uvw.y * tablePeriod.y);
    ivec2 nearest = ivec2(floor(frequency + 0.5));
    for (int across = -ACROSS; across <= ACROSS; ++across) {
        ivec2 bin = nearest + (alongX ? ivec2(0, across) : ivec2(across, 0));
        vec2 binFrequency = vec2(bin) / tablePeriod;
        float middle = dot(binFrequency, uvw.xy) / squaredLength;
        vec2 off = binFrequency - middle * uvw.xy;
        float gauss = windowPower(off, windowSigmaFrequency);
        float zeta = expansionPhase(uvw.z, orderWavelength(middle));
        xyz += gauss * binPower(bin - tableFirst, zeta) * orderWeight(middle, width);
    }
    return xyz;
}

vec3 diffractedXyz(vec3 uvw) {
    // A comparison of products is also right for |(u, v)| = 0.
    if (windowSigmaFrequency >= orderWidest * length(uvw.xy)) {
        return fixedWavelengthsXyz(uvw);
    }
    float width = windowSigmaFrequency / length(uvw.xy);
    // Columns of bins along the axis on which the ray crosses more of them.
    vec2 binsPerWaveNumber = abs(uvw.xy) * tablePeriod;
    bool alongX = binsPerWaveNumber.x >= binsPerWaveNumber.y;
    float waveNumberStep = 1.0 / (alongX ? binsPerWaveNumber.x : binsPerWaveNumber.y);
    // Columns beyond the band that reach into it: three standard deviations of an order, width / sqrt(2) each, and the columns by which the
    // bins across the ray are shifted.
    float reach = 2.2 * width / waveNumberStep + float(ACROSS);
    int first = max(1, int(ceil(1.0 / (LONGEST_WAVELENGTH * waveNumberStep) - reach)));
    int last = int(floor(1.0 / (SHORTEST_WAVELENGTH * waveNumberStep) + reach));
    vec3 xyz = vec3(0.0);
    for (int n = first; n <= last; ++n) {
        float waveNumber = float(n) * waveNumberStep;
        xyz += ORDERS_INTERFERE ? sampledColumn(uvw, width, waveNumber) : separateOrders(uvw, width, waveNumber);
    }
    float sigmaBins = alongX ? windowSigmaBins.x : windowSigmaBins.y;
    return ORDERS_INTERFERE ? xyz * sampleShare(width, waveNumberStep, sigmaBins) : xyz;
}

#ifdef SPECTRAL
// Power at one wavelength, the integrand of diffractedXyz: each order's Gaussian times the power at the order's own wavelength; if orders
// interfere, the power at the nearest column.
float orderPower(vec3 uvw, float wavelength, bool ensemble) {
    if (windowSigmaFrequency >= orderWidest * length(uvw.xy)) {
        return ensemble ? ensembleBinsPower(uvw, wavelength) : coherentBinsPower(uvw, wavelength);
    }
    vec2 binsPerWaveNumber = abs(uvw.xy) * tablePeriod;
    bool alongX = binsPerWaveNumber.x >= binsPerWaveNumber.y;
    float waveNumberStep = 1.0 / (alongX ? binsPerWaveNumber.x : binsPerWaveNumber.y);
    int column = int(floor(1.0 / (wavelength * waveNumberStep) + 0.5));
    if (ORDERS_OVERLAP == 1 && !ensemble) {
        float taken = orderWavelength(float(max(column, 1)) * waveNumberStep);
        return coherentBinsPowerAt(uvw, taken) / overrated(alongX ? windowSigmaBins.x : windowSigmaBins.y);
    }
    float squaredLength = dot(uvw.xy, uvw.xy);
    int reach = int(ceil(2.2 * windowSigmaFrequency / (sqrt(squaredLength) * waveNumberStep))) + ACROSS;
    float power = 0.0;
    for (int n = max(1, column - reach); n <= column + reach; ++n) {
        ivec2 nearest = ivec2(floor(uvw.xy * (float(n) * waveNumberStep) * tablePeriod + 0.5));
        for (int across = -ACROSS; across <= ACROSS; ++across) {
            ivec2 bin = nearest + (alongX ? ivec2(0, across) : ivec2(across, 0));
            vec2 binFrequency = vec2(bin) / tablePeriod;
            vec2 off = uvw.xy / wavelength - binFrequency;
            float zeta = expansionPhase(uvw.z, orderWavelength(dot(binFrequency, uvw.xy) / squaredLength));
            power += windowPower(off, windowSigmaFrequency) * binPower(bin - tableFirst, zeta);
        }
    }
    return power;
}

float coherentPower(vec3 uvw, float wavelength) {
    return orderPower(uvw, wavelength, false);
}

float ensemblePower(vec3 uvw, float wavelength) {
    return orderPower(uvw, wavelength, true);
}
#endif
