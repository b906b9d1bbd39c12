#define FEW_LOOP_STEPS
#include "include/color_table.glsl"

// Color table over (u, v) and slices of w, read at points. If COLOR_ONE_LIGHT is 1, the table is for one light: w follows from u and v, and
// there is one slice.

// Table coordinates of the first coefficient, coefficients per unit, tiles across and down, and the factor by which X, Y and Z are
// multiplied.
uniform vec2 colorOrigin;
uniform float colorTexelsPerUnit;
uniform vec2 colorTilesAcross;
uniform float colorScale;

#if COLOR_ONE_LIGHT == 1
uniform vec3 colorLight;

// Table coordinates: a view direction at the angle theta to the normal lies at the distance (sin(theta) + 2 sin(theta / 2)) / 2 from the
// origin.
vec2 pointPlace(vec3 uvw) {
    vec3 wr = -uvw - colorLight;
    return wr.xy * (0.5 + sqrt(0.5) * inversesqrt(1.0 + wr.z));
}
#else
vec2 pointPlace(vec3 uvw) {
    return uvw.xy;
}
#endif

vec3 diffractedXyz(vec3 uvw) {
    ColorGrid grid = ColorGrid(colorOrigin, colorTexelsPerUnit, colorTilesAcross, 0.0);
    return max(colorScale * COLOR_FILTER(pointPlace(uvw), uvw.z, grid), vec3(0.0));
}
