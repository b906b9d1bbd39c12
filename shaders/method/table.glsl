// Colours of power, tabulated over (u, v) and slices of w (sunbeam.precompute.colourtable): a cubic B-spline in (u, v) through
// square roots of X, Y, Z, a cubic polynomial through four slices. Under one light w follows from u and v: one slice has all.

// The spline's coefficients, pages beside each other; one layer a slice.
uniform sampler2DArray colourTexels;
// First texel of each page among them; z is 1 for those that exist.
uniform sampler2D colourPages;
// Place of the grid's first texel, texels per unit, and texels along a page's side.
uniform vec2 colourOrigin;
uniform float colourTexelsPerUnit;
uniform float colourPageSide;

#if COLOUR_SLICES == 1
// Towards the light.
uniform vec3 colourLight;

// The view at the angle theta to the normal lies at (sin(theta) + 2 sin(theta / 2)) / 2 from the middle.
vec2 colourPlace(vec3 uvw) {
    vec3 wr = -uvw - colourLight;
    return wr.xy * (0.5 + sqrt(0.5) * inversesqrt(1.0 + wr.z));
}
#else
// Slices per unit of |w|; the first lies at 0.
uniform float colourSlicesPerUnit;

vec2 colourPlace(vec3 uvw) {
    return uvw.xy;
}
#endif

// Where four bilinear look-ups of a layer lie that make up a cubic B-spline (C. Sigg and M. Hadwiger, "Fast third-order texture
// filtering", GPU Gems 2, chapter 20), and their weights along either axis.
struct SplinePlace {
    vec4 corners;
    vec2 lowWeight;
};

SplinePlace splinePlace(vec2 texel, vec2 size) {
    vec2 below = floor(texel);
    vec2 t = texel - below;
    vec2 s = 1.0 - t;
    vec2 w0 = s * s * s / 6.0;
    vec2 w1 = 2.0 / 3.0 - 0.5 * t * t * (2.0 - t);
    vec2 w3 = t * t * t / 6.0;
    vec2 low = w0 + w1;
    vec2 lowPlace = (below - 0.5 + w1 / low) / size;
    vec2 highPlace = (below + 1.5 + w3 / (1.0 - low)) / size;
    return SplinePlace(vec4(lowPlace, highPlace), low);
}

// X, Y, Z in a slice.
vec3 sliceXyz(SplinePlace place, float slice) {
    vec3 low = mix(
            texture(colourTexels, vec3(place.corners.zy, slice)).rgb,
            texture(colourTexels, vec3(place.corners.xy, slice)).rgb,
            place.lowWeight.x);
    vec3 high = mix(
            texture(colourTexels, vec3(place.corners.zw, slice)).rgb,
            texture(colourTexels, vec3(place.corners.xw, slice)).rgb,
            place.lowWeight.x);
    vec3 root = mix(high, low, place.lowWeight.y);
    return root * root;
}

vec3 diffractedXyz(vec3 uvw) {
    vec2 texel = (colourPlace(uvw) - colourOrigin) * colourTexelsPerUnit;
    vec2 page = floor(texel / colourPageSide);
    vec2 first = texelFetch(colourPages, ivec2(page), 0).xy;
    // A page begins a texel before its own.
    vec2 inTexels = first + 1.0 + texel - page * colourPageSide;
    SplinePlace place = splinePlace(inTexels, vec2(textureSize(colourTexels, 0).xy));
#if COLOUR_SLICES == 1
    return sliceXyz(place, 0.0);
#else
    float at = -uvw.z * colourSlicesPerUnit;
    float slice = clamp(floor(at) - 1.0, 0.0, float(COLOUR_SLICES - 4));
    // Lagrange's polynomials on 0, 1, 2, 3.
    float t0 = at - slice;
    float t1 = t0 - 1.0;
    float t2 = t0 - 2.0;
    float t3 = t0 - 3.0;
    return (t0 * t1 * t2 / 6.0) * sliceXyz(place, slice + 3.0)
            - (t0 * t1 * t3 / 2.0) * sliceXyz(place, slice + 2.0)
            + (t0 * t2 * t3 / 2.0) * sliceXyz(place, slice + 1.0)
            - (t1 * t2 * t3 / 6.0) * sliceXyz(place, slice);
#endif
}
