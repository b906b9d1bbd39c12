// What a moving picture needs of a pixel's skin, in four floats: moving_geometry.frag writes them, moving.frag reads them. A fourth of
// the memory of geometry.frag's images, and a fraction of a renderer's time for small triangles.

// A pixel of skin: columns T, B, N of its tangent frame in world space, and its texture as linear sRGB.
struct Skin {
    mat3 frame;
    vec3 albedo;
};

// Values that a channel of the texture can have, evenly along its square root: steps that screens show, too.
const float ALBEDO_STEPS = 255.0;

float signOf(float x) {
    return x < 0.0 ? -1.0 : 1.0;
}

// A unit vector on an octahedron, unfolded to a square, [-1, 1]^2 (Meyer et al. 2010), and the other way.
vec2 onOctahedron(vec3 unit) {
    vec3 on = unit / (abs(unit.x) + abs(unit.y) + abs(unit.z));
    vec2 folded = (1.0 - abs(on.yx)) * vec2(signOf(on.x), signOf(on.y));
    return on.z < 0.0 ? folded : on.xy;
}

vec3 fromOctahedron(vec2 square) {
    float z = 1.0 - abs(square.x) - abs(square.y);
    vec2 folded = (1.0 - abs(square.yx)) * vec2(signOf(square.x), signOf(square.y));
    return normalize(vec3(z < 0.0 ? folded : square, z));
}

// Some unit vector orthogonal to another (Duff et al. 2017).
vec3 someTangent(vec3 normal) {
    float side = signOf(normal.z);
    float a = -1.0 / (side + normal.z);
    return vec3(1.0 + side * normal.x * normal.x * a, side * normal.x * normal.y * a, -side * normal.x);
}

// A direction of the plane by its place on a square instead of a circle, [-2, 2]: no arc tangent.
float onDiamond(vec2 direction) {
    float place = direction.y / max(abs(direction.x) + abs(direction.y), 1e-30);
    return direction.x < 0.0 ? 2.0 * signOf(direction.y) - place : place;
}

vec2 fromDiamond(float place) {
    float x = 1.0 - abs(place);
    return normalize(vec2(x, x < 0.0 ? 2.0 * signOf(place) - place : place));
}

// Where a pixel shows no skin, all four are 0.
bool showsSkin(vec4 texel) {
    return texel.w > 0.0;
}

vec4 packedSkin(Skin skin) {
    // Of the normal as it will be read, so that both sides mean the same tangent.
    vec2 square = onOctahedron(skin.frame[2]);
    vec3 normal = fromOctahedron(square);
    vec3 some = someTangent(normal);
    float place = onDiamond(vec2(dot(skin.frame[0], some), dot(skin.frame[0], cross(normal, some))));
    float handedness = signOf(dot(cross(skin.frame[2], skin.frame[0]), skin.frame[1]));
    vec3 steps = floor(sqrt(clamp(skin.albedo, 0.0, 1.0)) * ALBEDO_STEPS + 0.5);
    // Whole numbers up to 2^24 are exact.
    return vec4(square, handedness * (place + 3.0), 1.0 + steps.r + 256.0 * (steps.g + 256.0 * steps.b));
}

Skin unpackedSkin(vec4 texel) {
    vec3 normal = fromOctahedron(texel.xy);
    vec3 some = someTangent(normal);
    vec2 turn = fromDiamond(abs(texel.z) - 3.0);
    vec3 tangent = turn.x * some + turn.y * cross(normal, some);
    vec3 shifted = floor((texel.w - 1.0) * vec3(1.0, 1.0 / 256.0, 1.0 / 65536.0));
    vec3 root = (shifted - 256.0 * vec3(shifted.yz, 0.0)) / ALBEDO_STEPS;
    return Skin(mat3(tangent, signOf(texel.z) * cross(normal, tangent), normal), root * root);
}
