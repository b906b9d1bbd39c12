// What a moving picture needs of a pixel's skin, in four floats: moving_geometry.frag writes them, moving.frag reads them. A fourth of
// the memory of geometry.frag's images, and a fraction of a renderer's time for small triangles, so that writing is what has to be
// cheap: nothing is brought to unit length there.

// A pixel of skin: columns T, B, N of its tangent frame in world space, and its texture as linear sRGB.
struct Skin {
    mat3 frame;
    vec3 albedo;
    // Share of the sky that is seen, in steps.
    float sky;
};

// Values that a channel of the texture can have, evenly along its square root: steps that screens show, too.
const float ALBEDO_STEPS = 255.0;
const float SKY_STEPS = 255.0;

float signOf(float x) {
    return x < 0.0 ? -1.0 : 1.0;
}

// A direction on an octahedron, unfolded to a square, [-1, 1]^2 (Meyer et al. 2010), and the other way; of any length.
vec2 onOctahedron(vec3 direction) {
    vec3 on = direction / max(abs(direction.x) + abs(direction.y) + abs(direction.z), 1e-30);
    vec2 folded = (1.0 - abs(on.yx)) * vec2(signOf(on.x), signOf(on.y));
    return on.z < 0.0 ? folded : on.xy;
}

vec3 fromOctahedron(vec2 square) {
    float z = 1.0 - abs(square.x) - abs(square.y);
    vec2 folded = (1.0 - abs(square.yx)) * vec2(signOf(square.x), signOf(square.y));
    return vec3(z < 0.0 ? folded : square, z);
}

// A direction of the plane by its place on a square instead of a circle, [-2, 2]: no arc tangent; of any length.
float onDiamond(vec2 direction) {
    float place = direction.y / max(abs(direction.x) + abs(direction.y), 1e-30);
    return direction.x < 0.0 ? 2.0 * signOf(direction.y) - place : place;
}

vec2 fromDiamond(float place) {
    float x = 1.0 - abs(place);
    return vec2(x, x < 0.0 ? 2.0 * signOf(place) - place : place);
}

// Columns: some vector orthogonal to another, and one orthogonal to both and as long. Along the y axis the first is as short as
// rounding, but from the same normal it comes out the same when it is read, and only the angle to it is kept.
struct Plane {
    vec3 first;
    vec3 second;
};

Plane someBasis(vec3 normal) {
    float length = sqrt(dot(normal, normal));
    vec3 first = vec3(normal.z, 0.0, -normal.x) + vec3(1e-12, 0.0, 0.0);
    return Plane(length * first, cross(normal, first));
}

// Where a pixel shows no skin, all four are 0.
bool showsSkin(vec4 texel) {
    return texel.w > 0.0;
}

// normal, tangent: of any length, the latter with any part along the former; turn: cosine and sine of the frame's turn about the normal.
// sky: the share of it that is seen.
vec4 packedSkin(vec3 normal, vec4 tangent, vec2 turn, vec3 albedo, float sky) {
    // Of the normal as it will be read, so that both sides mean the same tangent.
    vec2 square = onOctahedron(normal);
    Plane plane = someBasis(fromOctahedron(square));
    vec2 place = vec2(dot(tangent.xyz, plane.first), dot(tangent.xyz, plane.second));
    vec2 turned = vec2(turn.x * place.x - turn.y * place.y, turn.y * place.x + turn.x * place.y);
    vec3 steps = floor(sqrt(clamp(albedo, 0.0, 1.0)) * ALBEDO_STEPS + 0.5);
    float share = floor(clamp(sky, 0.0, 1.0) * SKY_STEPS + 0.5);
    // Whole numbers up to 2^24 are exact; 2^-12 of a diamond are left of the third, a hundredth of a degree.
    return vec4(
            square,
            signOf(tangent.w) * (onDiamond(turned) + 3.0 + 8.0 * share),
            1.0 + steps.r + 256.0 * (steps.g + 256.0 * steps.b));
}

Skin unpackedSkin(vec4 texel) {
    vec3 normal = fromOctahedron(texel.xy);
    Plane plane = someBasis(normal);
    float share = floor(abs(texel.z) * 0.125);
    vec2 place = fromDiamond(abs(texel.z) - 8.0 * share - 3.0);
    vec3 along = place.x * plane.first + place.y * plane.second;
    vec3 tangent = along * inversesqrt(dot(along, along));
    normal *= inversesqrt(dot(normal, normal));
    vec3 shifted = floor((texel.w - 1.0) * vec3(1.0, 1.0 / 256.0, 1.0 / 65536.0));
    vec3 root = (shifted - 256.0 * vec3(shifted.yz, 0.0)) / ALBEDO_STEPS;
    return Skin(mat3(tangent, signOf(texel.z) * cross(normal, tangent), normal), root * root, share / SKY_STEPS);
}
