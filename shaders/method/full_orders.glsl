// For patches so small that the window resolves every diffraction order: wavelengths are placed around the middle of each
// order that the direction sees, and only the nearest bin is looked at.

// How far from an order's middle wavelengths lie, and their distance, in deviations of the order's power.
uniform float orderReach;
uniform float orderNodeSpacing;
// Their largest distance in metres.
uniform float orderLargestStep;
// Wavelengths within the specular order, which has no middle.
uniform int specularNodes;
// Standard deviation of the window's spectrum, cycles per metre.
uniform float windowSigmaFrequency;

float orderPower(vec3 uvw, float wavelength) {
#if AVERAGE == AVERAGE_ENSEMBLE
    return ensemblePower(uvw, wavelength);
#else
    return coherentPower(uvw, wavelength);
#endif
}

// Trapezoid rule in 1 / lambda, which spaces an order evenly: d lambda = lambda^2 d(1 / lambda).
vec3 contribution(vec3 uvw, float waveNumber) {
    float wavelength = 1.0 / waveNumber;
    return cieWeight(wavelength) * (wavelength * wavelength * orderPower(uvw, wavelength));
}

// Power of the order of bin (0, 0), which covers the whole band at once; constant power comes out exactly.
vec3 specularOrder(vec3 uvw) {
    float first = 1.0 / LONGEST_WAVELENGTH;
    float stepSize = (1.0 / SHORTEST_WAVELENGTH - first) / float(specularNodes - 1);
    vec3 sum = vec3(0.0);
    vec3 weights = vec3(0.0);
    for (int i = 0; i < specularNodes; ++i) {
        float wavelength = 1.0 / (first + stepSize * float(i));
        vec3 weight = cieWeight(wavelength) * (wavelength * wavelength);
        sum += weight * orderPower(uvw, wavelength);
        weights += weight;
    }
    return sum * cieWhite / weights;
}

// An order that an end of the visible band cuts. The trapezoid rule would err by a share of the node at the cut, which
// is all there is where only a flank is inside: Simpson's rule on what is left, in steps of a sixth of the spacing.
vec3 cutOrder(vec3 uvw, float low, float high, float spacing) {
    int halfSteps = int(ceil(3.0 * (high - low) / spacing));
    float stepSize = (high - low) / float(2 * halfSteps);
    vec3 sum = contribution(uvw, low) + contribution(uvw, high);
    for (int i = 1; i < 2 * halfSteps; ++i) {
        sum += (2.0 + 2.0 * float(i & 1)) * contribution(uvw, low + float(i) * stepSize);
    }
    return sum * (stepSize / 3.0);
}

vec3 oneOrder(vec3 uvw, vec2 bin) {
    vec2 frequency = bin / tablePeriod;
    float squaredLength = dot(uvw.xy, uvw.xy);
    // Where the ray f = (u, v) / lambda passes closest to the bin.
    float middle = dot(frequency, uvw.xy) / squaredLength;
    float deviation = windowSigmaFrequency * inversesqrt(2.0 * squaredLength);
    float spacing = min(orderNodeSpacing * deviation, orderLargestStep * middle * middle);
    float low = max(middle - orderReach * deviation, 1.0 / LONGEST_WAVELENGTH);
    float high = min(middle + orderReach * deviation, 1.0 / SHORTEST_WAVELENGTH);
    if (low >= high) {
        return vec3(0.0);
    }
    if (high - low < 1.999 * orderReach * deviation) {
        return cutOrder(uvw, low, high, spacing);
    }
    int halfNodes = int(ceil(orderReach * deviation / spacing));
    vec3 sum = vec3(0.0);
    for (int i = -halfNodes; i <= halfNodes; ++i) {
        sum += contribution(uvw, middle + float(i) * spacing);
    }
    return sum * spacing;
}

vec3 diffractedXyz(vec3 uvw) {
    // Five deviations out of the specular order at the longest wavelength, its power is e^-25.
    const float SPECULAR_REACH = 5.0;
    if (length(uvw.xy) < SPECULAR_REACH * windowSigmaFrequency * LONGEST_WAVELENGTH) {
        return specularOrder(uvw);
    }
    // Orders along the axis on which the ray crosses more of them; on the other, the one nearest to the ray.
    vec2 binsPerWaveNumber = uvw.xy * tablePeriod;
    bool alongX = abs(binsPerWaveNumber.x) >= abs(binsPerWaveNumber.y);
    float major = alongX ? binsPerWaveNumber.x : binsPerWaveNumber.y;
    float minor = alongX ? binsPerWaveNumber.y : binsPerWaveNumber.x;
    float reach = orderReach * windowSigmaFrequency * max(tablePeriod.x, tablePeriod.y);
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
