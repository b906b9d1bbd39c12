#define FEW_LOOP_STEPS
#include "include/color_spline.glsl"

// Colors of power, tabulated over (u, v) and slices of w (sunbeam.precompute.colortable): a cubic B-spline in (u, v) through
// square roots of X, Y, Z, a cubic polynomial through four slices. Under one light w follows from u and v: one slice has all.

// First texel of each tile in the layer of any slice; z is 1 for those that exist.
uniform sampler2D colorTiles;
// Place of the grid's first texel, texels per unit, and texels along a tile's side.
uniform vec2 colorOrigin;
uniform float colorTexelsPerUnit;
uniform float colorTileSide;

#if COLOR_SLICES == 1
// Towards the light.
uniform vec3 colorLight;

// The view at the angle theta to the normal lies at (sin(theta) + 2 sin(theta / 2)) / 2 from the middle.
vec2 colorPlace(vec3 uvw) {
    vec3 wr = -uvw - colorLight;
    return wr.xy * (0.5 + sqrt(0.5) * inversesqrt(1.0 + wr.z));
}
#else
vec2 colorPlace(vec3 uvw) {
    return uvw.xy;
}
#endif

vec3 diffractedXyz(vec3 uvw) {
    vec2 texel = (colorPlace(uvw) - colorOrigin) * colorTexelsPerUnit;
    vec2 tile = floor(texel / colorTileSide);
    // The nearest texel: software renderers take longer to fetch one by its number.
    vec2 first = textureLod(colorTiles, (tile + 0.5) / vec2(textureSize(colorTiles, 0)), 0.0).xy;
    // A tile begins a texel before its own.
    vec2 inTexels = first + 1.0 + texel - tile * colorTileSide;
    SplinePlace place = splinePlace(inTexels, 1.0 / vec2(textureSize(colorTexels, 0).xy));
#if COLOR_SLICES == 1
    return splineXyz(place, 0.0);
#else
    SlicePlace slices = slicePlace(uvw.z, COLOR_SLICES);
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        xyz += slices.weights[i] * splineXyz(place, float(slices.first + i));
    }
    return xyz;
#endif
}
