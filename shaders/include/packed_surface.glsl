#include "include/octahedron.glsl"

// Geometry buffer of pictures drawn while something moves: four floats per pixel, a fourth of geometry.frag's images; moving_geometry.frag
// writes it and moving.frag reads it. With small triangles packing takes most of the time; so it normalizes no vector.

// A pixel of skin: columns T, B, N of its tangent frame in world space, and its texture as linear sRGB.
struct Skin {
    mat3 frame;
    vec3 albedo;
    // Visible share of the sky, quantized.
    float sky;
    // False where the skin has no nanostructure, whose texels have a negative w.
    bool hasPatch;
};

// Steps of a texture channel, even in the channel's square root, which makes them about as fine as steps of sRGB.
const float ALBEDO_STEPS = 255.0;
const float SKY_STEPS = 255.0;

// Encodes a direction in the plane, of any length, as a position from -2 to 2 on the perimeter of a diamond. Unlike an angle it needs no
// arc tangent.
float onDiamond(vec2 direction) {
    float place = direction.y / max(abs(direction.x) + abs(direction.y), 1e-30);
    return direction.x < 0.0 ? 2.0 * signOf(direction.y) - place : place;
}

vec2 fromDiamond(float place) {
    float x = 1.0 - abs(place);
    return vec2(x, x < 0.0 ? 2.0 * signOf(place) - place : place);
}

// Two vectors of equal length, orthogonal to a normal and to each other. For a normal near the y axis they are as short as rounding errors;
// that is harmless, since packing and unpacking compute the same vectors from the same normal, and only the tangent's angle to the first is
// stored.
struct Plane {
    vec3 first;
    vec3 second;
};

Plane someBasis(vec3 normal) {
    float length = sqrt(dot(normal, normal));
    vec3 first = vec3(normal.z, 0.0, -normal.x) + vec3(1e-12, 0.0, 0.0);
    return Plane(length * first, cross(normal, first));
}

// All four floats are 0 where a pixel shows no skin.
bool showsSkin(vec4 texel) {
    return texel.w != 0.0;
}

// normal: of any length; tangent: of any length, need not be orthogonal to the normal, and has the sign of the frame's handedness in w;
// turn: cosine and sine of the frame's turn about the normal; sky: visible share of the sky.
vec4 packedSkin(vec3 normal, vec4 tangent, vec2 turn, vec3 albedo, float sky) {
    // Uses the normal as it will be unpacked, so that packing and unpacking have the same basis.
    vec2 square = onOctahedron(normal);
    Plane plane = someBasis(fromOctahedron(square));
    vec2 place = vec2(dot(tangent.xyz, plane.first), dot(tangent.xyz, plane.second));
    vec2 turned = vec2(turn.x * place.x - turn.y * place.y, turn.y * place.x + turn.x * place.y);
    vec3 steps = floor(sqrt(clamp(albedo, 0.0, 1.0)) * ALBEDO_STEPS + 0.5);
    float share = floor(clamp(sky, 0.0, 1.0) * SKY_STEPS + 0.5);
    // Integers up to 2^24 are exact. The third float holds the share of the sky and the angle, which keeps steps of 2^-12, a hundredth of a
    // degree.
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
    vec3 shifted = floor((abs(texel.w) - 1.0) * vec3(1.0, 1.0 / 256.0, 1.0 / 65536.0));
    vec3 root = (shifted - 256.0 * vec3(shifted.yz, 0.0)) / ALBEDO_STEPS;
    mat3 frame = mat3(tangent, signOf(texel.z) * cross(normal, tangent), normal);
    return Skin(frame, root * root, share / SKY_STEPS, texel.w > 0.0);
}
