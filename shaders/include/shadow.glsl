// What the first light reaches (sunbeam.app.scene.Shadows): a map of depths, softly compared (percentage-closer filtering, Reeves et al.
// 1987), the softer the farther away what casts it (Fernando 2005).

// One minus the depth of what the light meets first.
uniform sampler2D shadowMap;
uniform mat4 worldToShadow;
// How many places of the map are compared; 0 without shadows.
uniform int shadowTaps;
// Metres along the normal by which a surface is lifted, lest it shade itself.
uniform float shadowLift;

const float SHADOW_BIAS = 0.002;
const float PENUMBRA = 0.05;
const float SHARPEST = 0.0016;
const float SOFTEST = 0.02;

// Some place of a disc of radius 1, evenly (Vogel 1979), turned differently from pixel to pixel (Jimenez 2014), lest steps show.
vec2 onDisc(float number, float count) {
    float turn = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float angle = 2.39996323 * number + 6.28318531 * turn;
    return sqrt((number + 0.5) / count) * vec2(cos(angle), sin(angle));
}

// The share of the light that reaches a point.
float litShare(vec3 world, vec3 normal) {
    vec4 clip = worldToShadow * vec4(world + shadowLift * normal, 1.0);
    vec3 at = 0.5 * clip.xyz / clip.w + 0.5;
    // What is farther than the map reaches is lit.
    float depth = max(1.0 - at.z, 0.0) + SHADOW_BIAS;
    float count = float(shadowTaps);
    float nearer = 0.0;
    float hidden = 0.0;
    for (int tap = 0; tap < shadowTaps; tap += 2) {
        float above = textureLod(shadowMap, at.xy + SOFTEST * onDisc(float(tap), count), 0.0).r - depth;
        hidden += above > 0.0 ? 1.0 : 0.0;
        nearer += max(above, 0.0);
    }
    float radius = clamp(PENUMBRA * nearer / max(hidden, 1.0), SHARPEST, SOFTEST);
    float dark = 0.0;
    for (int tap = 0; tap < shadowTaps; ++tap) {
        float above = textureLod(shadowMap, at.xy + radius * onDisc(float(tap), count), 0.0).r - depth;
        dark += above > 0.0 ? 1.0 : 0.0;
    }
    return 1.0 - dark / max(count, 1.0);
}
