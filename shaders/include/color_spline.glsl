// Cubic B-splines in tables of colors (sunbeam.precompute.colortable).

// The spline's coefficients, of square roots of X, Y and Z: tiles beside each other.
uniform sampler2DArray colorTexels;

// Where four bilinear look-ups of a layer lie that make up a cubic B-spline (C. Sigg and M. Hadwiger, "Fast third-order texture
// filtering", GPU Gems 2, chapter 20), and their weights along either axis.
struct SplinePlace {
    vec4 corners;
    vec2 lowWeight;
};

// texel: counted from the middle of the first; perSize: one over the layer's sides, in texels.
SplinePlace splinePlace(vec2 texel, vec2 perSize) {
    vec2 below = floor(texel);
    vec2 t = texel - below;
    vec2 s = 1.0 - t;
    vec2 w0 = s * s * s / 6.0;
    vec2 w1 = 2.0 / 3.0 - 0.5 * t * t * (2.0 - t);
    vec2 w3 = t * t * t / 6.0;
    vec2 low = w0 + w1;
    vec2 lowPlace = (below - 0.5 + w1 / low) * perSize;
    vec2 highPlace = (below + 1.5 + w3 / (1.0 - low)) * perSize;
    return SplinePlace(vec4(lowPlace, highPlace), low);
}

// X, Y, Z there.
vec3 splineXyz(SplinePlace place, float layer) {
    vec3 low = mix(
            texture(colorTexels, vec3(place.corners.zy, layer)).rgb,
            texture(colorTexels, vec3(place.corners.xy, layer)).rgb,
            place.lowWeight.x);
    vec3 high = mix(
            texture(colorTexels, vec3(place.corners.zw, layer)).rgb,
            texture(colorTexels, vec3(place.corners.xw, layer)).rgb,
            place.lowWeight.x);
    vec3 root = mix(high, low, place.lowWeight.y);
    return root * root;
}

// Slices per unit of |w|; the first lies at 0.
uniform float colorSlicesPerUnit;

// The first of the four slices that w is interpolated between, of so many, and what each of them weighs: Lagrange's polynomials.
struct SlicePlace {
    int first;
    vec4 weights;
};

SlicePlace slicePlace(float w, int slices) {
    float at = max(-w, 0.0) * colorSlicesPerUnit;
    float first = clamp(floor(at) - 1.0, 0.0, float(slices - 4));
    float t0 = at - first;
    float t1 = t0 - 1.0;
    float t2 = t0 - 2.0;
    float t3 = t0 - 3.0;
    return SlicePlace(
            int(first),
            vec4(-t1 * t2 * t3 / 6.0, t0 * t2 * t3 / 2.0, -t0 * t1 * t3 / 2.0, t0 * t1 * t2 / 6.0));
}
