#include "include/average.glsl"
#include "method/neighborhood.glsl"

// For small and periodic patches with few significant bins: each bin is a diffraction order of the repeated patch.
//
// If the window resolves every order (ORDERS_RESOLVED is 1), each order is integrated over wavelengths around its center, with the power of
// its own bin alone. Orders that overlap are integrated together over the whole band.

// Largest distance of nodes from an order's center, and distance between nodes, in standard deviations of the order's power over 1 /
// lambda.
uniform float orderReach;
uniform float orderNodeSpacing;
// Size of the panels of Gauss's rule for orders that an end of the band cuts, in the same unit.
uniform float orderPanel;
// Largest distance between nodes in wavelength, in meters.
uniform float orderLargestStep;
// Limit that a corner of D65's table within an order sets: square of the distance between nodes, divided by the order's deviation, both in
// wavelength; meters.
uniform float orderCornerLength;
// Standard deviation of the window's spectrum, cycles per meter.
uniform float windowSigmaFrequency;

// Distance from an order's center, in standard deviations, at which its power is 1e-9 of its maximum, which is invisible.
const float FLANK_REACH = 6.5;
// Standard deviation of an order in wavelength, meters, below which corners of the CIE's tables influence its color (ShaderArrays).
const float NARROW_ORDER = 0.4e-9;

struct Ray {
    vec3 uvw;
    // If allBins is false, the only bin whose power counts, and where the ray passes closest to it: at 1 / lambda = middle, at this
    // distance in cycles per meter.
    bool allBins;
    ivec2 bin;
    float middle;
    float distance;
};

#include "include/integral.glsl"

float powerAtStep(Ray ray, int step, float wavelength) {
    if (ray.allBins) {
        return averagePower(ray.uvw, wavelength);
    }
    vec2 off = vec2(ray.distance, (1.0 / wavelength - ray.middle) * length(ray.uvw.xy)) / windowSigmaFrequency;
    return windowPower(off, 1.0) * binPower(ray.bin - tableFirst, expansionPhase(ray.uvw.z, wavelength));
}

vec3 oneOrder(vec3 uvw, vec2 bin) {
    vec2 frequency = bin / tablePeriod;
    float squaredLength = dot(uvw.xy, uvw.xy);
    // Where the ray f = (u, v) / lambda passes closest to the bin.
    float middle = dot(frequency, uvw.xy) / squaredLength;
    float distance = (frequency.x * uvw.y - frequency.y * uvw.x) * inversesqrt(squaredLength);
    float deviation = windowSigmaFrequency * inversesqrt(2.0 * squaredLength);
    // An order outside the band shows only a flank, which may be the only light. If an order lies near the band's ends, the flank towards
    // the band's middle has larger CIE weights than the order's center.
    bool inside = middle * LONGEST_WAVELENGTH > 1.03 && middle * SHORTEST_WAVELENGTH < 0.97;
    float halfWidth = (inside ? orderReach : FLANK_REACH) * deviation;
    float low = max(middle - halfWidth, 1.0 / LONGEST_WAVELENGTH);
    float high = min(middle + halfWidth, 1.0 / SHORTEST_WAVELENGTH);
    if (high <= low || abs(distance) > FLANK_REACH * windowSigmaFrequency) {
        return vec3(0.0);
    }
    Ray ray = Ray(uvw, false, ivec2(bin), middle, distance);
    // Light from the relief's top and bottom interferes with this many fringes per unit of 1 / lambda. One more step per fringe keeps the
    // trapezoid rule's error as without fringes.
    float fringes = 2.0 * heightHalfRange * abs(uvw.z);
    // Distance from the order's center to its part in the band, in standard deviations: the farther out, the steeper the flank.
    float flank = max(0.0, max(low - middle, middle - high)) / deviation;
    float seen = deviation / (1.0 + flank);
    float largestStep = min(orderLargestStep * middle * middle, middle * sqrt(orderCornerLength * deviation));
    int weights = seen < NARROW_ORDER * middle * middle ? TABLE_WEIGHTS : SMOOTH_WEIGHTS;
    // Where the band cuts an order, the trapezoid rule is inaccurate, since power does not vanish at the ends; Gauss's rule replaces it.
    if (low > middle - halfWidth || high < middle + halfWidth) {
        float largest = min(orderPanel / (1.0 / seen + 2.0 * PI * fringes), 3.0 * largestStep);
        return partXyz(ray, panelsBetween(low, high, largest), weights);
    }
    float spacing = min(orderNodeSpacing * deviation, largestStep);
    int intervals = max(int(ceil((high - low) * (1.0 / spacing + fringes))), 2);
    return partXyz(ray, Steps(low, (high - low) / float(intervals), 0, intervals, false, 0.0, 0.0),
            weights);
}

vec3 diffractedXyz(vec3 uvw) {
    // The order of bin (0, 0) covers the whole band at once. At this distance from it, in window sigmas at the longest wavelength, its
    // power is e^-25.
    const float SPECULAR_REACH = 5.0;
    if (ORDERS_RESOLVED == 0 || length(uvw.xy) < SPECULAR_REACH * windowSigmaFrequency * LONGEST_WAVELENGTH) {
        return cutBandXyz(Ray(uvw, true, ivec2(0), 0.0, 0.0), length(uvw.xy));
    }
    // One order for each bin along the axis on which the ray crosses more bins; on the other axis the bin nearest to the ray.
    vec2 binsPerWaveNumber = uvw.xy * tablePeriod;
    bool alongX = abs(binsPerWaveNumber.x) >= abs(binsPerWaveNumber.y);
    float major = alongX ? binsPerWaveNumber.x : binsPerWaveNumber.y;
    float minor = alongX ? binsPerWaveNumber.y : binsPerWaveNumber.x;
    float reach = FLANK_REACH * windowSigmaFrequency * max(tablePeriod.x, tablePeriod.y);
    int first = max(1, int(ceil(abs(major) / LONGEST_WAVELENGTH - reach)));
    int last = int(floor(abs(major) / SHORTEST_WAVELENGTH + reach));
    vec3 xyz = vec3(0.0);
    for (int m = first; m <= last; ++m) {
        float majorBin = float(m) * sign(major);
        float minorBin = floor(majorBin * minor / major + 0.5);
        xyz += oneOrder(uvw, alongX ? vec2(majorBin, minorBin) : vec2(minorBin, majorBin));
    }
    return xyz;
}
