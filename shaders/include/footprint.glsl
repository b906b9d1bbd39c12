// Footprint of a pixel in (u, v, w): taps along its major axis, in the mip level of colors whose blur fits its minor axis
// (method/table_levels.glsl).

// Variance in (u, v) of what the finest level shows of a sharp order where |w| is small; each further level's is twice as large.
uniform float finestVariance;
uniform int levels;
// Variance of what a point shows of a sharp order, and of the slopes of relief that all levels are averages over, 0 for none.
uniform float pointVariance;
uniform float tabulatedSlopeVariance;
// Levels before these that are for samples which see points alone: 1 or 0.
uniform float pointLevels;
// Variance of the slopes, along either axis, of relief that is finer than a pixel and that the levels do not have.
uniform float slopeVariance;
// Most taps along the major axis; if these do not reach, a coarser level blurs the minor axis, too.
uniform float mostTaps;
// Samples of the mesh along a side of a pixel, whose mean it will be.
uniform float samplesAcross;

struct Footprint {
    vec3 center;
    // Number of the level.
    float level;
    // Change of (u, v, w) along the line that the taps divide evenly, and their number.
    vec3 axis;
    float taps;
};

// Distance of taps, in standard deviations of what the level shows of a sharp order: at 1.6 of them a row of Gaussians is even within
// 2 exp(-2 pi^2 / 1.6^2) = 9e-4.
const float SPACING = 1.6;
// What a whole pixel sees along its major axis counts as a point below this share of the finest level's variance.
const float POINT = 0.06;

// du, dv: change of (u, v, w) from the sample to the next, to the right and up.
Footprint footprintOf(vec3 uvw, vec3 du, vec3 dv) {
    // Squared lengths of the axes of an ellipse: eigenvalues of du du^T + dv dv^T, twelve times the covariance of an even parallelogram.
    float difference = 0.5 * (dot(du.xy, du.xy) - dot(dv.xy, dv.xy));
    float mixed = dot(du.xy, dv.xy);
    float middle = 0.5 * (dot(du.xy, du.xy) + dot(dv.xy, dv.xy));
    float root = sqrt(difference * difference + mixed * mixed);
    // Relief moves (u, v) by its slopes times w, along both axes alike (Toksvig 2005; Olano and Baker 2010).
    float relief = 12.0 * slopeVariance * uvw.z * uvw.z;
    float majorSquare = middle + root + relief;
    float minorSquare = max(middle - root, 0.0) + relief;

    float shown = max(tabulatedSlopeVariance * uvw.z * uvw.z + pointVariance, finestVariance);
    float reach = mostTaps * SPACING;
    float fitting = floor(log2(1.0 + minorSquare / (12.0 * finestVariance)));
    float needed = ceil(log2(max(1.0, 1.0 + (majorSquare / (reach * reach + 12.0) - shown) / finestVariance)));
    float level = clamp(max(fitting, needed), 0.0, float(levels - 1));
    // Taps cover what the level does not blur.
    float blur = (exp2(level) - 1.0) * finestVariance;
    float lengthSquare = max(majorSquare - 12.0 * blur, 0.0);
    float taps = clamp(ceil(sqrt(lengthSquare / (shown + blur)) / SPACING), 1.0, mostTaps);

    // The major axis is du cos + dv sin. Of a circle any direction will do, of a point that of relief.
    vec2 turn = difference > 0.0 ? vec2(difference + root, mixed) : vec2(mixed, root - difference);
    turn = root > 0.0 ? normalize(turn) : vec2(1.0, 0.0);
    vec3 axis = turn.x * du + turn.y * dv;
    axis = middle > 0.0 ? axis * inversesqrt(middle + root) : vec3(1.0, 0.0, 0.0);
    bool seesPoint = samplesAcross * samplesAcross * majorSquare < 12.0 * POINT * finestVariance;
    return Footprint(uvw, seesPoint ? 0.0 : level + pointLevels, sqrt(lengthSquare) * axis, taps);
}
