// Footprint of a pixel in (u, v, w): taps along its major axis, in the mip level of the color table whose blur fits its minor axis
// (method/table_levels.glsl).

// Variance in (u, v), along either axis, of a sharp order's image in the finest level where |w| is small; it doubles from level to level.
uniform float finestVariance;
uniform int levels;
// Variance of a sharp order's image at a point; variance of the relief's slopes that all levels already average over, 0 for none.
uniform float pointVariance;
uniform float tabulatedSlopeVariance;
// Number of levels for samples that see a single point, 1 or 0; such a level comes before those of footprints.
uniform float pointLevels;
// Variance, along either axis, of the slopes of relief finer than a pixel; 0 if the levels already average over it.
uniform float slopeVariance;
// Finest level that is read, points included; 0 for all levels.
uniform float leastLevel;
// Most taps along the major axis; if these are too few, a coarser level blurs the minor axis, too.
uniform float mostTaps;
// 0 to mix two levels under a wide light, so that the mean of both has its variance; more to read one level alone, the next if the fitting one
// lacks less than this share of a level.
uniform float levelRounding;
// Variance of a light over that of its region of an environment, so that a row of lights is even; 1 for lights that stand alone.
uniform float lightOverlap;
// Number of samples of the mesh along a pixel's side; the pixel is the mean of its samples.
uniform float samplesAcross;

struct Footprint {
    vec3 center;
    // 0 is the finest.
    float level;
    // Change of (u, v, w) along the line over which the taps are spread evenly, a part of the major axis, and the number of taps.
    vec3 axis;
    float taps;
    // Share of the next level's color, 0 without a wide light: with it the mean of both has the minor axis's variance.
    float nextShare;
};

// Distance between taps, in standard deviations of a sharp order's image in the level: a row of Gaussians 1.6 deviations apart is even to 2
// exp(-2 pi^2 / 1.6^2) = 9e-4.
const float SPACING = 1.6;
// Pixels count as points if their variance along the major axis is below this share of the finest level's variance.
const float POINT = 0.06;

// du, dv: change of (u, v, w) from the sample to the next, to the right and up. wi, lightVariance, stretch: direction towards the light, the
// variance of its directions along the shorter axis across it, and LIGHT_STRETCH in the tangent frame. next: 0, or 1 for the footprint in the
// next level.
Footprint footprintOf(vec3 uvw, vec3 du, vec3 dv, vec3 wi, float lightVariance, vec3 stretch, float next) {
    // Squared lengths of the axes: eigenvalues of du du^T + dv dv^T, which is twelve times the covariance of a uniform parallelogram, and of
    // that of the light.
    // Relief moves (u, v) by its slopes times w, along both axes alike (Toksvig 2005; Olano and Baker 2010); what it blurs needs no overlap.
    float blurred = (slopeVariance + tabulatedSlopeVariance) * uvw.z * uvw.z;
    float overlap = max(1.0, lightOverlap - blurred / max(lightVariance, 1e-12));
    float light = 12.0 * overlap * lightVariance;
    vec3 longer = sqrt(12.0 * overlap) * stretch;
    float squareU = du.x * du.x + dv.x * dv.x + longer.x * longer.x + light * (1.0 - wi.x * wi.x);
    float squareV = du.y * du.y + dv.y * dv.y + longer.y * longer.y + light * (1.0 - wi.y * wi.y);
    float difference = 0.5 * (squareU - squareV);
    float mixed = du.x * du.y + dv.x * dv.y + longer.x * longer.y - light * wi.x * wi.y;
    float middle = 0.5 * (squareU + squareV);
    float root = sqrt(difference * difference + mixed * mixed);
    float relief = 12.0 * slopeVariance * uvw.z * uvw.z;
    float majorSquare = middle + root + relief;
    float minorSquare = max(middle - root, 0.0) + relief;

    float shown = max(tabulatedSlopeVariance * uvw.z * uvw.z + pointVariance, finestVariance);
    float reach = mostTaps * SPACING;
    float fitting = floor(log2(1.0 + minorSquare / (12.0 * finestVariance)) + levelRounding);
    float needed = ceil(log2(max(1.0, 1.0 + (majorSquare / (reach * reach + 12.0) - shown) / finestVariance)));
    float level = clamp(max(fitting, needed) + next, leastLevel - pointLevels, float(levels - 1));
    // Taps cover the part of the major axis that the level does not blur.
    float blur = (exp2(level) - 1.0) * finestVariance;
    float lengthSquare = max(majorSquare - 12.0 * blur, 0.0);
    float taps = clamp(ceil(sqrt(lengthSquare / (shown + blur)) / SPACING), 1.0, mostTaps);

    // The major axis in (u, v), and the change of (u, v, w) that goes with it. A circular footprint may have any direction; so may that of
    // a point, whose extent comes from relief alone.
    vec2 turn = difference > 0.0 ? vec2(difference + root, mixed) : vec2(mixed, root - difference);
    turn = root > 0.0 ? normalize(turn) : vec2(1.0, 0.0);
    vec3 axis = dot(turn, du.xy) * du + dot(turn, dv.xy) * dv + dot(turn, longer.xy) * longer
            + light * (vec3(turn, 0.0) - dot(turn, wi.xy) * wi);
    axis = middle > 0.0 ? axis / (middle + root) : vec3(1.0, 0.0, 0.0);
    float nextShare = lightVariance > 0.0 && levelRounding == 0.0 ? clamp((minorSquare / 12.0 - blur) / (exp2(level) * finestVariance), 0.0, 1.0) : 0.0;
    bool seesPoint = samplesAcross * samplesAcross * majorSquare < 12.0 * POINT * finestVariance;
    return Footprint(uvw, seesPoint ? leastLevel : level + pointLevels, sqrt(lengthSquare) * axis, taps, nextShare);
}
