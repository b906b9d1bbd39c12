// Diffraction of @PATCH@ (coherence length @LENGTH@), made by sunbeam @VERSION@: docs/export.md of Sunbeam has the formula.
@LANGUAGE@
//
// Square roots of X, Y, Z, times 256; layers are slices of |w|, mip levels show orders ever twice as wide. Linear filters, edges clamped.
uniform sampler2DArray sunbeamTable;

// u and v of the first texel, their step and number; |w| of the first slice, their distance and number.
const vec2 SUNBEAM_FIRST = vec2(@U@, @V@);
const float SUNBEAM_STEP = @STEP@;
const vec2 SUNBEAM_COUNT = vec2(@COLUMNS@, @ROWS@);
const float SUNBEAM_DEPTH = @DEPTH@;
const float SUNBEAM_DEPTH_STEP = @DEPTH_STEP@;
const float SUNBEAM_SLICES = @SLICES@;
// Standard deviation in (u, v) of an order in the finest level, and the coarsest level.
const float SUNBEAM_SIGMA = @SIGMA@;
const float SUNBEAM_COARSEST = @COARSEST@;
// Places along what a pixel sees, and their distance in standard deviations.
const float SUNBEAM_TAPS = 8.0;
const float SUNBEAM_SPACING = 1.6;

const mat3 SUNBEAM_XYZ_TO_REC709 = mat3(
        3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314, 0.0415560, 1.0572252);

// X, Y, Z of diffracted power: roots are linear along u and v, their squares cubic through four slices of w.
vec3 sunbeamPower(vec3 uvw, float level) {
    vec2 place = ((uvw.xy - SUNBEAM_FIRST) / SUNBEAM_STEP + 0.5) / SUNBEAM_COUNT;
    float at = clamp((-uvw.z - SUNBEAM_DEPTH) / SUNBEAM_DEPTH_STEP, 0.0, SUNBEAM_SLICES - 1.0);
    float first = clamp(floor(at) - 1.0, 0.0, SUNBEAM_SLICES - 4.0);
    vec4 t = at - first - vec4(0.0, 1.0, 2.0, 3.0);
    vec4 weights = vec4(-t.y * t.z * t.w / 6.0, t.x * t.z * t.w / 2.0, -t.x * t.y * t.w / 2.0, t.x * t.y * t.z / 6.0);
    vec3 xyz = vec3(0.0, 0.0, 0.0);
    for (int i = 0; i < 4; i++) {
        vec3 root = textureLod(sunbeamTable, vec3(place, first + float(i)), level).rgb;
        xyz += weights[i] * root * root;
    }
    return max(xyz / 65536.0, vec3(0.0, 0.0, 0.0));
}

// The mean over a pixel's footprint: du and dv are how far (u, v, w) moves from the pixel to the next, to the right and up.
vec3 sunbeamMean(vec3 uvw, vec3 du, vec3 dv) {
    float a = dot(du.xy, du.xy);
    float b = dot(dv.xy, dv.xy);
    float c = dot(du.xy, dv.xy);
    float root = sqrt(0.25 * (a - b) * (a - b) + c * c);
    float turn = 0.0;
    if (root > 0.0) {
        turn = 0.5 * atan(2.0 * c, a - b);
    }
    vec3 axis = cos(turn) * du + sin(turn) * dv;
    float wide = 0.5 * (a + b) + root;
    float narrow = max(0.5 * (a + b) - root, 0.0);
    // A level blurs by what the minor axis sees, or what so many places along the major axis leave out.
    float reach = SUNBEAM_TAPS * SUNBEAM_SPACING;
    float blur = max(narrow, 12.0 * wide / (reach * reach)) / (12.0 * SUNBEAM_SIGMA * SUNBEAM_SIGMA);
    float level = min(0.5 * log2(1.0 + blur), SUNBEAM_COARSEST);
    float taps = clamp(ceil(sqrt(wide) / (SUNBEAM_SPACING * SUNBEAM_SIGMA * exp2(level))), 1.0, SUNBEAM_TAPS);
    vec3 sum = vec3(0.0, 0.0, 0.0);
    for (float i = 0.5; i < taps; i += 1.0) {
        sum += sunbeamPower(uvw + (i / taps - 0.5) * axis, level);
    }
    return sum / taps;
}

// From power to radiance: Schlick's reflectance of 0.04 over its own along the normal, Kirchhoff's factor, masking of V-shaped cavities.
float sunbeamGain(vec3 wi, vec3 wr) {
    vec3 sum = wi + wr;
    float c = 0.5 * length(sum);
    float k = 2.0 * c * c;
    float mask = min(1.0, 2.0 * sum.z * min(wi.z, wr.z) / k);
    return (1.0 + 24.0 * pow(max(1.0 - c, 0.0), 5.0)) * k * k / (sum.z * sum.z * wr.z) * mask;
}

// X, Y, Z of the radiance under a light, over that of a flat mirror of the same material seen along the normal; no further
// cosine. wi to the light, wr to the viewer, unit vectors in the tangent frame: x tangent, y bitangent, z normal. du and dv as above,
// for example dFdx(-(wi + wr)) and dFdy(-(wi + wr)); zero for a point.
vec3 sunbeamXyz(vec3 wi, vec3 wr, vec3 du, vec3 dv) {
    if (wi.z > 0.0 && wr.z > 0.0) {
        return sunbeamGain(wi, wr) * sunbeamMean(-(wi + wr), du, dv);
    }
    return vec3(0.0, 0.0, 0.0);
}

// The same in linear Rec. 709 (sRGB) red, green, blue; negative outside of the gamut.
vec3 sunbeam(vec3 wi, vec3 wr, vec3 du, vec3 dv) {
    return SUNBEAM_XYZ_TO_REC709 * sunbeamXyz(wi, wr, du, dv);
}
