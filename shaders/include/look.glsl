// What of (u, v, w) a pixel sees, in which level of colours (method/table_levels.glsl), and in how many places.

// Standard deviation in (u, v) of what the finest level shows of a sharp order; each further level's is sqrt(2) times as large.
uniform float finestSigma;
uniform int levels;
// Beyond so many places along the wide side a coarser level blurs the narrow side, too.
uniform float mostPlaces;
// Samples of the mesh along a side of a pixel, whose mean it will be.
uniform float samplesAcross;

// How a pixel looks into levels.
struct Look {
    // (u, v, w) in the middle, and the level.
    vec4 place;
    // By how much (u, v, w) changes along the wide side of what it sees, and in how many places it looks there.
    vec4 wide;
    // As much of the narrow side. Seen from there, the parallelogram is a trapezoid: the fraction of w is 0.9 times the ratio of its
    // shorter edge to its longer one.
    vec4 narrow;
};

// A level may blur by this share of the variance of what is seen along the narrow side; the places lie so much closer that the
// variance stays.
const float BLUR = 0.75;
// Of what a pixel of several samples sees, a level may blur by this share: their places are not moved.
const float PIXEL_BLUR = 0.2;
// Distance of the places that are looked at, in standard deviations of what the level shows of a sharp order: at 1.6 of them a row
// of Gaussians is even within 2 exp(-2 pi^2 / 1.6^2) = 9e-4.
const float SPACING = 1.6;

// Twelve times the variances of an evenly filled parallelogram along its narrow and its wide side.
vec2 variances(vec2 a, vec2 b) {
    float trace = dot(a, a) + dot(b, b);
    float determinant = a.x * b.y - a.y * b.x;
    determinant *= determinant;
    float wide = 0.5 * trace + sqrt(max(0.25 * trace * trace - determinant, 0.0));
    // The smaller root of a quadratic equation, without its cancellation.
    return trace > 0.0 ? vec2(determinant / wide, wide) : vec2(0.0);
}

// By how much (u, v, w) changes over what is seen along a unit vector of (u, v): of w, what goes with it.
vec3 changeAlong(vec3 a, vec3 b, vec2 side, float length) {
    vec2 shares = vec2(dot(a.xy, side), dot(b.xy, side));
    float depth = dot(vec2(a.z, b.z), shares) / max(dot(shares, shares), 1e-30);
    return length * vec3(side, depth);
}

// Unit vector along the wide side of a parallelogram: the eigenvector of a a^T + b b^T.
vec2 wideSide(vec2 a, vec2 b, float wide) {
    float mixed = a.x * a.y + b.x * b.y;
    vec2 one = vec2(wide - a.y * a.y - b.y * b.y, mixed);
    vec2 other = vec2(mixed, wide - a.x * a.x - b.x * b.x);
    vec2 side = dot(one, one) > dot(other, other) ? one : other;
    return dot(side, side) > 0.0 ? normalize(side) : vec2(1.0, 0.0);
}

// a, b: change of (u, v, w) from the pixel to the next along either side of the picture.
Look lookOver(vec3 uvw, vec3 a, vec3 b) {
    vec2 seen = variances(a.xy, b.xy) / 12.0;
    float variance = finestSigma * finestSigma;
    float blur = max(BLUR, samplesAcross > 1.0 ? PIXEL_BLUR * samplesAcross * samplesAcross : 0.0) * seen.x;
    float narrow = log2(1.0 + blur / variance);
    vec2 side = wideSide(a.xy, b.xy, 12.0 * seen.y);
    // The trapezoid's edges, seen from the narrow side.
    vec2 edges = abs(vec2(dot(a.xy, side), dot(b.xy, side)));
    float longer = edges.x + edges.y;
    float wide = 2.0 * log2(max(longer / (mostPlaces * SPACING * finestSigma), 1.0));
    int level = clamp(int(max(floor(narrow), ceil(wide))), 0, levels - 1);
    // Level l blurs by (2^l - 1) of the finest level's variance.
    float blurred = (exp2(float(level)) - 1.0) * variance;
    vec2 rest = max(seen - blurred, 0.0);
    // Along the wide side the trapezoid shrinks; along the narrow one an even line has what is left of the variance.
    float wideLength = longer * sqrt(rest.y / max(seen.y, 1e-30));
    float narrowLength = sqrt(12.0 * rest.x);
    float spacing = SPACING * finestSigma * exp2(0.5 * float(level));
    vec2 places = clamp(ceil(vec2(wideLength, narrowLength) / spacing), 1.0, mostPlaces);
    vec4 place = vec4(uvw, float(level));
    vec4 wideLook = vec4(changeAlong(a, b, side, wideLength), places.x);
    float shorter = abs(edges.x - edges.y) / max(longer, 1e-30);
    vec4 narrowLook = vec4(changeAlong(a, b, vec2(-side.y, side.x), narrowLength), places.y + 0.9 * shorter);
    return Look(place, wideLook, narrowLook);
}
