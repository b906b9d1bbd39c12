#include "include/spectrum.glsl"
#include "method/grid_tables.glsl"

// Interpolates windowed spectra on a grid of frequencies. A direction's frequencies lie on the ray f = (u, v) / lambda. It is sampled at
// the wavelengths at which it crosses the grid's columns (rows if |v| > |u|), so that only one axis needs interpolation.

// COHERENT_TEXELS, ENSEMBLE_TEXELS: number of texels with an average's terms at one frequency, 0 without this average; ..._TOGETHER: number
// of them side by side in a row; ..._LAYERS: layers of one grid. GRID_ENDS_CUT: 1 if power does not vanish at the band's ends (cut of
// include/integral.glsl).

// Distance between columns, and between rows, in cycles per meter.
uniform float gridNodeStep;
// Samples per cycle per meter along a column.
uniform float gridRayScale;
// Index of the first column and of the first sample on it: x, y for columns along x; z, w for rows along y.
uniform vec4 gridRaysFirst;
// Rays with max(|u|, |v|) below gridCenterReach cross too few columns; others are sampled at gridFewestNodes of them or more.
uniform float gridCenterReach;
uniform int gridFewestNodes;
// Longest step along a ray, in distances between columns: a ray that crosses many columns is sampled at every second or third one.
uniform float gridLongestStep;

// Tables of each average: a grid for any position (Point) and one for rays (Rays), with layers for columns along x, then for rows along y.
// With RAYS_APART the grid for rays is two textures, Columns and Rows, because of the driver's size limit. Shaders for colors have the
// tables of one average only.

#if COHERENT_TEXELS > 0
uniform sampler2DArray coherentPoint;
#if RAYS_APART
uniform sampler2DArray coherentColumns;
uniform sampler2DArray coherentRows;
#else
uniform sampler2DArray coherentRays;
#endif
uniform sampler2D coherentCoefficients;
uniform vec2 coherentPhaseMap;
// Grid for any position: samples per cycle per meter, and index of the first sample along x and y.
uniform float coherentScale;
uniform vec2 coherentPointFirst;

float coherentPower(vec3 uvw, float wavelength) {
    Place place = inGrid(uvw.xy / wavelength * coherentScale, coherentPointFirst);
    float zeta = expansionPhase(uvw.z, wavelength);
    Terms terms = Terms(COHERENT_TEXELS, COHERENT_POINT_TOGETHER, 0);
    return squaredMagnitude(
            amplitudeAt(coherentPoint, terms, place, coherentCoefficients, coherentPhaseMap, zeta));
}
#endif

#if ENSEMBLE_TEXELS > 0
// Four real terms per texel.
uniform sampler2DArray ensemblePoint;
#if RAYS_APART
uniform sampler2DArray ensembleColumns;
uniform sampler2DArray ensembleRows;
#else
uniform sampler2DArray ensembleRays;
#endif
uniform sampler2D ensembleCoefficients;
uniform vec2 ensemblePhaseMap;
uniform float ensembleScale;
uniform vec2 ensemblePointFirst;

float ensemblePower(vec3 uvw, float wavelength) {
    Place place = inGrid(uvw.xy / wavelength * ensembleScale, ensemblePointFirst);
    float zeta = expansionPhase(uvw.z, wavelength);
    Terms terms = Terms(ENSEMBLE_TEXELS, ENSEMBLE_POINT_TOGETHER, 0);
    return realSumAt(ensemblePoint, terms, place, ensembleCoefficients, ensemblePhaseMap, zeta);
}
#endif

#ifndef SPECTRAL

#if COHERENT_TEXELS > 0
#define COLUMNS coherentColumns
#define ROWS coherentRows
#define RAYS coherentRays
#define RAYS_LAYERS COHERENT_RAYS_LAYERS

float powerIn(sampler2DArray grid, int firstLayer, Place place, float zeta) {
    Terms terms = Terms(COHERENT_TEXELS, COHERENT_RAYS_TOGETHER, firstLayer);
    return squaredMagnitude(amplitudeAt(grid, terms, place, coherentCoefficients, coherentPhaseMap, zeta));
}
#else
#define COLUMNS ensembleColumns
#define ROWS ensembleRows
#define RAYS ensembleRays
#define RAYS_LAYERS ENSEMBLE_RAYS_LAYERS

float powerIn(sampler2DArray grid, int firstLayer, Place place, float zeta) {
    Terms terms = Terms(ENSEMBLE_TEXELS, ENSEMBLE_RAYS_TOGETHER, firstLayer);
    return realSumAt(grid, terms, place, ensembleCoefficients, ensemblePhaseMap, zeta);
}
#endif

// Power where the ray crosses a column along x, or a row along y.
float columnPower(bool alongX, Place place, float zeta) {
#if RAYS_APART
    return alongX ? powerIn(COLUMNS, 0, place, zeta) : powerIn(ROWS, 0, place, zeta);
#else
    return powerIn(RAYS, alongX ? 0 : RAYS_LAYERS, place, zeta);
#endif
}

struct Ray {
    vec3 uvw;
    // True if step i lies where the ray crosses a column, columnsPerStep times i columns from frequency 0. All members below are for such
    // rays.
    bool meetsColumns;
    bool alongX;
    // Columns per step, negative for a ray towards lower columns, and samples along the columns per step.
    float columnsPerStep;
    float samplesPerStep;
    vec2 origin;
    float zetaPerStep;
};

#include "include/integral.glsl"

float powerAtStep(Ray ray, int step, float wavelength) {
    if (!ray.meetsColumns) {
        return averagePower(ray.uvw, wavelength);
    }
    float i = float(step);
    Place place = onColumn(int(i * ray.columnsPerStep - ray.origin.x), i * ray.samplesPerStep, ray.origin.y);
    return columnPower(ray.alongX, place, i * ray.zetaPerStep);
}

vec3 diffractedXyz(vec3 uvw) {
    bool alongX = abs(uvw.x) >= abs(uvw.y);
    float major = alongX ? uvw.x : uvw.y;
    if (abs(major) < gridCenterReach) {
        // Near the specular direction both axes are interpolated.
        Ray ray = Ray(uvw, false, alongX, 0.0, 0.0, vec2(0.0), 0.0);
        return cutBandXyz(ray, length(uvw.xy));
    }
    float minorPerColumn = (alongX ? uvw.y : uvw.x) / abs(major) * gridNodeStep * gridRayScale;
    // A column more is gridNodeStep / |major| more in 1 / lambda, to which the phase is proportional.
    float crossed = abs(major) / gridNodeStep * (1.0 / SHORTEST_WAVELENGTH - 1.0 / LONGEST_WAVELENGTH);
    float longest = gridLongestStep * abs(major) / length(uvw.xy);
    int stride = max(1, int(min(longest, crossed / float(gridFewestNodes))));
    float waveNumberStep = gridNodeStep * float(stride) / abs(major);
    Ray ray = Ray(
            uvw,
            true,
            alongX,
            sign(major) * float(stride),
            float(stride) * minorPerColumn,
            alongX ? gridRaysFirst.xy : gridRaysFirst.zw,
            expansionPhase(uvw.z, 1.0) * waveNumberStep);
    float low = 1.0 / (LONGEST_WAVELENGTH * waveNumberStep);
    float high = 1.0 / (SHORTEST_WAVELENGTH * waveNumberStep);
    Steps steps = Steps(0.0, waveNumberStep, int(ceil(low)), int(floor(high)), GRID_ENDS_CUT == 1, 0.0, 0.0);
    steps.beyondFirst = float(steps.first) - low;
    steps.beyondLast = high - float(steps.last);
    return bandXyz(ray, steps);
}

#endif
