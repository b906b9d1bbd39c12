// The look-up of D. Dhillon et al., "Interactive Diffraction from Biological Nanostructures" (2014), for comparison: a colour is a
// polynomial in w whose coefficients are tabulated over (u, v), one bilinear look-up each.

// X, Y, Z of the coefficient of (|w| / 2)^r in layer r.
uniform sampler2DArray taylorTables;

vec3 diffractedXyz(vec3 uvw) {
    vec2 place = 0.25 * uvw.xy + 0.5;
    float w = -0.5 * uvw.z;
    vec3 sum = vec3(0.0);
    for (int r = TAYLOR_TABLES - 1; r >= 0; --r) {
        sum = sum * w + texture(taylorTables, vec3(place, float(r))).rgb;
    }
    return sum;
}
