#include "include/spectrum.glsl"

// Integrals over the visible band in equal steps of 1 / lambda, along the ray f = (u, v) / lambda, on which equal steps are
// equally long: dlambda = lambda^2 d(1 / lambda).
//
// GLSL hands no functions over. So a method that integrates defines `struct Ray` before it includes this file, what it
// works out of a direction before it looks at wavelengths, and after it the power at a step. (Members of a Ray that are
// constants stay constants in the loop: compilers put all calls in line.)
float powerAtStep(Ray ray, int step, float wavelength);

// Step i, from first to last, both included, lies at 1 / lambda = origin + i size. At an end that is cut the integrand does
// not vanish, and the trapezoid rule gets Gregory's correction: three nodes each, which must not overlap.
struct Steps {
    float origin;
    float size;
    int first;
    int last;
    bool cutFirst;
    bool cutLast;
};

const int FEWEST_CUT_INTERVALS = 6;

// Equal steps from one end of the band to the other.
Steps wholeBand(int count) {
    float origin = 1.0 / LONGEST_WAVELENGTH;
    return Steps(origin, (1.0 / SHORTEST_WAVELENGTH - origin) / float(count - 1), 0, count - 1, false, false);
}

// The same for power that does not vanish at the ends: that of a lone order may be all there is to see.
Steps cutBand(int count) {
    Steps steps = wholeBand(count);
    steps.cutFirst = true;
    steps.cutLast = true;
    return steps;
}

// Factor of the i-th step from a cut end.
float endWeight(int i) {
    return i == 0 ? 3.0 / 8.0 : i == 1 ? 7.0 / 6.0 : i == 2 ? 23.0 / 24.0 : 1.0;
}

// CIE XYZ of the power seen, and of the power 1, both in units of one step.
struct Integral {
    vec3 power;
    vec3 one;
};

Integral overSteps(Ray ray, Steps steps) {
    Integral sum = Integral(vec3(0.0), vec3(0.0));
    for (int i = steps.first; i <= steps.last; ++i) {
        float wavelength = 1.0 / (steps.origin + steps.size * float(i));
        vec3 weight = cieWeight(wavelength) * (wavelength * wavelength);
        weight *= steps.cutFirst ? endWeight(i - steps.first) : 1.0;
        weight *= steps.cutLast ? endWeight(steps.last - i) : 1.0;
        sum.power += weight * powerAtStep(ray, i, wavelength);
        sum.one += weight;
    }
    return sum;
}

// CIE XYZ of what the steps cover.
vec3 partXyz(Ray ray, Steps steps) {
    return steps.size * overSteps(ray, steps).power;
}

// CIE XYZ of the whole band: constant power comes out exactly, however few the steps.
vec3 bandXyz(Ray ray, Steps steps) {
    Integral sum = overSteps(ray, steps);
    return sum.power * cieWhite / sum.one;
}
