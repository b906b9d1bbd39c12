#include "include/spectrum.glsl"

// Integrals over the visible band, mostly in equal steps of 1 / lambda, which are equally long on the ray f = (u, v) / lambda. dlambda =
// lambda^2 d(1 / lambda) gives the steps' weights.
//
// GLSL cannot pass functions as arguments. Before a method includes this file, it defines `struct Ray`, values that depend on the direction
// alone; afterwards it defines the power at a step. (Constant members of a Ray stay constants in the loop: compilers inline all calls.)
float powerAtStep(Ray ray, int step, float wavelength);

// Steps i from first to last, both included, lie at 1 / lambda = origin + i size. If cut is true, the integrand does not vanish at the
// band's ends: the trapezoid rule gets corrections of the four steps next to each end, which must not overlap, and an end lies at most one
// step beyond the outermost one.
struct Steps {
    float origin;
    float size;
    int first;
    int last;
    bool cut;
    // Distance from the first step to the lower end of the band and from the last step to the upper end, in steps.
    float beyondFirst;
    float beyondLast;
};

Steps wholeBand(int count) {
    float origin = 1.0 / LONGEST_WAVELENGTH;
    return Steps(origin, (1.0 / SHORTEST_WAVELENGTH - origin) / float(count - 1), 0, count - 1, false, 0.0, 0.0);
}

// Weights of the four steps next to a cut end, the outermost step first; the end lies t steps beyond it. They contain Euler and Maclaurin's
// corrections and the integral over these t steps, with derivatives by forward differences. Exact for cubics; Gregory's rule if t is 0.
vec4 endWeights(float t) {
    float first = 1.0 / 12.0 - 0.5 * t * t;
    float cube = t * t * t / 6.0;
    float second = cube - 0.5 * first;
    float third = first / 3.0 - cube - 1.0 / 720.0 - 0.25 * t * cube;
    return vec4(0.5 + t - first + second - third, 1.0 + first - 2.0 * second + 3.0 * third, 1.0 + second - 3.0 * third,
            1.0 + third);
}

// Gauss's rule of four nodes on each of several panels of 1 / lambda, for power that does not vanish at the band's ends. Possibly only the
// steep flank of a single order is visible: all panels have one size, except three at each end, with a quarter, a quarter and a half of it.
struct Panels {
    float low;
    float size;
    int count;
};

const float GAUSS_PLACES[4] = float[](0.06943184, 0.33000948, 0.66999052, 0.93056816);
const float GAUSS_WEIGHTS[4] = float[](0.17392742, 0.32607258, 0.32607258, 0.17392742);
const int GRADED_PANELS = 4;

// Panels between two values of 1 / lambda, of a largest size or smaller.
Panels panelsBetween(float low, float high, float largestSize) {
    // Robust against float32 rounding where the largest size divides the band.
    int equal = max(int(ceil((high - low) / largestSize - 1e-3)), 2);
    return Panels(low, (high - low) / float(equal), equal + GRADED_PANELS);
}

// Lower edge of a panel near the lower end, in panel sizes from that end.
float gradedEdge(int panel) {
    return panel < 3 ? 0.25 * float(panel) : float(panel - 2);
}

float panelEdge(Panels panels, int panel) {
    return 2 * panel <= panels.count
            ? gradedEdge(panel)
            : float(panels.count - GRADED_PANELS) - gradedEdge(panels.count - panel);
}

// CIE XYZ of the power, and of a constant power of 1; both must be multiplied by the size of a step or panel.
struct Integral {
    vec3 power;
    vec3 one;
};

Integral overSteps(Ray ray, Steps steps, int weights) {
    Integral sum = Integral(vec3(0.0), vec3(0.0));
    vec4 low = endWeights(steps.beyondFirst);
    vec4 high = endWeights(steps.beyondLast);
    for (int i = steps.first; i <= steps.last; ++i) {
        float wavelength = 1.0 / (steps.origin + steps.size * float(i));
        vec3 weight = cieWeight(wavelength, weights) * (wavelength * wavelength);
        if (steps.cut) {
            weight *= i < steps.first + 4 ? low[i - steps.first] : i > steps.last - 4 ? high[steps.last - i] : 1.0;
        }
        sum.power += weight * powerAtStep(ray, i, wavelength);
        sum.one += weight;
    }
    return sum;
}

Integral overPanels(Ray ray, Panels panels, int weights) {
    Integral sum = Integral(vec3(0.0), vec3(0.0));
    for (int i = 0; i < 4 * panels.count; ++i) {
        float from = panelEdge(panels, i / 4);
        float width = panelEdge(panels, i / 4 + 1) - from;
        float wavelength = 1.0 / (panels.low + panels.size * (from + width * GAUSS_PLACES[i % 4]));
        vec3 weight = cieWeight(wavelength, weights) * (wavelength * wavelength * width * GAUSS_WEIGHTS[i % 4]);
        sum.power += weight * powerAtStep(ray, i, wavelength);
        sum.one += weight;
    }
    return sum;
}

// CIE XYZ of the range that the steps cover.
vec3 partXyz(Ray ray, Steps steps, int weights) {
    return steps.size * overSteps(ray, steps, weights).power;
}

vec3 partXyz(Ray ray, Panels panels, int weights) {
    return panels.size * overPanels(ray, panels, weights).power;
}

// CIE XYZ of the whole band; exact for constant power with any number of steps.
vec3 bandXyz(Ray ray, Steps steps) {
    Integral sum = overSteps(ray, steps, SMOOTH_WEIGHTS);
    return sum.power * cieWhite / sum.one;
}

// Integral over the band of power that need not vanish at the band's ends (BandRule of sunbeam.precompute.plan.Sampling):
// bandFewestNodes equal steps up to |(u, v)| = bandReach, panels beyond. bandPanel limits a panel's length along the ray, in cycles per
// meter; bandLargestPanel limits its size in 1 / lambda, in 1 / meter.
uniform int bandFewestNodes;
uniform float bandReach;
uniform float bandPanel;
uniform float bandLargestPanel;

vec3 cutBandXyz(Ray ray, float uv) {
    if (uv <= bandReach) {
        Steps steps = wholeBand(bandFewestNodes);
        steps.cut = true;
        return bandXyz(ray, steps);
    }
    float largest = min(bandLargestPanel, bandPanel / uv);
    Integral sum = overPanels(ray, panelsBetween(1.0 / LONGEST_WAVELENGTH, 1.0 / SHORTEST_WAVELENGTH, largest),
            SMOOTH_WEIGHTS);
    return sum.power * cieWhite / sum.one;
}
