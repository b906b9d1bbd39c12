// What of (u, v, w) a pixel sees, in which level of colors (method/table_levels.glsl), and in how many places.

// Variance in (u, v) of what the finest level shows of a sharp order where |w| is small, and one over it; each further level's is twice as large.
uniform float finestVariance;
uniform float perFinestVariance;
uniform int levels;
// Variance of what a point shows of a sharp order, and of the slopes of relief that all levels are averages over, 0 for none.
uniform float pointVariance;
uniform float tabulatedSlopeVariance;
// Tables before these that are for pixels which see points alone: 1 or 0.
uniform float pointLevels;
// Beyond so many places along the major axis a coarser level blurs the minor axis, too.
uniform float mostPlaces;
// Samples of the mesh along a side of a pixel, whose mean it will be.
uniform float samplesAcross;

// How a pixel looks into levels.
struct Footprint {
    // (u, v, w) in the middle, and the number of the table.
    vec4 place;
    // By how much (u, v, w) changes along the major axis of what it sees, and in how many places it looks there.
    vec4 wide;
    // As much of the minor axis.
    vec4 narrow;
    // Seen from the minor axis, the parallelogram is a trapezoid: the ratio of its shorter edge to its longer one.
    float edges;
};

// A level may blur by this share of the variance of what is seen along the minor axis; the places lie so much closer that the
// variance stays.
const float BLUR = 0.75;
// Of several samples a pixel, each may be blurred by all that it sees and by this share of what the pixel does, which so sees that much
// more: an eighth more in width. Their places are not moved.
const float PIXEL_BLUR = 0.25;
// Distance of the places that are looked at, in standard deviations of what the level shows of a sharp order: at 1.6 of them a row
// of Gaussians is even within 2 exp(-2 pi^2 / 1.6^2) = 9e-4.
const float SPACING = 1.6;
// What a whole pixel sees along its major axis counts as a point below this share of the variance of what the finest level shows of a sharp order.
const float POINT = 0.06;

// The bits of floats: floor(log2(x)) and ceil(log2(x)) of a normal positive number, and 2^n.
int floorOfLog2(float x) {
    return (floatBitsToInt(x) >> 23) - 127;
}

int ceilOfLog2(float x) {
    return ((floatBitsToInt(x) + 0x7fffff) >> 23) - 127;
}

float powerOfTwo(int n) {
    return intBitsToFloat((n + 127) << 23);
}

// a, b: change of (u, v, w) from the pixel to the next along either side of the picture. unseenSlopes: the variance of slopes of relief that is finer
// than a pixel, along either axis (Toksvig 2005; Olano and Baker 2010): a slope moves (u, v) by itself times w.
Footprint footprintOf(vec3 uvw, vec3 a, vec3 b, float unseenSlopes) {
    float relief = unseenSlopes * uvw.z * uvw.z;
    // a a^T + b b^T: twelve times the covariance of an evenly filled parallelogram. Its eigenvectors are the sides, of any length.
    vec2 squares = a.xy * a.xy + b.xy * b.xy;
    float mixed = a.x * a.y + b.x * b.y;
    float determinant = a.x * b.y - a.y * b.x;
    determinant *= determinant;
    float halfTrace = 0.5 * (squares.x + squares.y);
    float wideRoot = halfTrace + sqrt(max(halfTrace * halfTrace - determinant, 0.0));
    float perWideRoot = 1.0 / max(wideRoot, 1e-30);
    // The smaller root of a quadratic equation, without its cancellation.
    vec2 shape = vec2(determinant * perWideRoot, wideRoot) / 12.0;
    vec2 seen = shape + relief;
    vec2 side = squares.x > squares.y ? vec2(wideRoot - squares.y, mixed) : vec2(mixed, wideRoot - squares.x);
    // A square: any direction will do.
    side = dot(side, side) == 0.0 ? vec2(1.0, 0.0) : side;
    float perSideSquare = 1.0 / max(dot(side, side), 1e-36);
    // The trapezoid's edges, seen from the minor axis.
    vec2 edges = vec2(dot(a.xy, side), dot(b.xy, side));
    float longer = abs(edges.x) + abs(edges.y);
    float longerSquare = longer * longer * perSideSquare + 12.0 * relief;

    float blur = (samplesAcross > 1.0 ? 1.0 + PIXEL_BLUR * samplesAcross * samplesAcross : BLUR) * shape.x + relief;
    int narrow = floorOfLog2(1.0 + blur * perFinestVariance);
    float finestSpan = mostPlaces * SPACING;
    float finestSeen = max(tabulatedSlopeVariance * uvw.z * uvw.z + pointVariance, finestVariance);
    // What a level blurs by need not be spanned.
    int wide = ceilOfLog2(max(
            1.0 + (longerSquare / (finestSpan * finestSpan + 12.0) - finestSeen) * perFinestVariance, 1.0));
    int level = clamp(max(narrow, wide), 0, levels - 1);
    float doublings = powerOfTwo(level);
    // Level l blurs by (2^l - 1) of the finest level's variance.
    vec2 rest = max(seen - (doublings - 1.0) * finestVariance, 0.0);
    // Along the major axis the trapezoid shrinks; along the minor one an even line has what is left of the variance.
    vec2 lengthSquares = 12.0 * vec2(longerSquare * rest.y / (12.0 * seen.y + 1e-30), rest.x);
    float perSpacingSquare = 1.0 / (SPACING * SPACING * (finestSeen + (doublings - 1.0) * finestVariance));
    vec2 places = clamp(ceil(sqrt(lengthSquares * perSpacingSquare)), 1.0, mostPlaces);

    vec2 depths = vec2(a.z, b.z);
    vec2 scales = sqrt(lengthSquares * perSideSquare);
    // Slopes are covariances over variances; the edges' squares add up to the root times the side's. Relief moves (u, v, w) on a sphere.
    vec2 onSphere = -relief / min(uvw.z, -1e-6) * uvw.xy;
    float wideDepth = (dot(depths, edges) / 12.0 + dot(onSphere, side)) / max(seen.y, 1e-30);
    vec2 narrowSide = vec2(-side.y, side.x);
    vec2 narrowEdges = vec2(dot(a.xy, narrowSide), dot(b.xy, narrowSide));
    float narrowVariance = dot(narrowEdges, narrowEdges) * perSideSquare / 12.0 + relief;
    float narrowDepth = (dot(depths, narrowEdges) / 12.0 + dot(onSphere, narrowSide)) / max(narrowVariance, 1e-36);
    float shorter = abs(abs(edges.x) - abs(edges.y)) / max(longer, 1e-36);
    return Footprint(
            vec4(uvw, samplesAcross * samplesAcross * seen.y < POINT * finestVariance ? 0.0 : float(level) + pointLevels),
            vec4(scales.x * vec3(side, wideDepth), places.x),
            vec4(scales.y * vec3(narrowSide, narrowDepth), places.y),
            shorter);
}
