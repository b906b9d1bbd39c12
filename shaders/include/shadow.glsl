// Shadows of the first light (app.render.GeometryBuffer): a depth map with percentage-closer filtering (Reeves et al. 1987); the penumbra
// widens with the distance of the occluder (Fernando 2005).

// Depth of the first surface that the light meets, 0 to 1.
uniform sampler2D shadowMap;
uniform mat4 worldToShadow;
uniform int shadowed;
// Offset along the normal in meters, so that a surface does not shade itself.
uniform float shadowLift;

// SHADOW_TAPS: texels of the map that are compared; a define, so that compilers unroll the loops.

// Depth, as a share of the map's range, by which a shaded surface lies behind the map's at least, so that a surface does not shade itself.
const float SHADOW_BIAS = 0.002;
// Radius of the filter, as a share of the map's side: per depth from occluder to surface, and the smallest and the largest radius.
const float PENUMBRA = 0.05;
const float SHARPEST = 0.0016;
const float SOFTEST = 0.02;

// Taps spread evenly over the unit disc (Vogel 1979): each is turned by the golden angle from the one before.
const mat2 GOLDEN_TURN = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

// Direction of the first tap; it differs from pixel to pixel (Jimenez 2014), which hides banding.
vec2 firstOnDisc() {
    float angle = 6.28318531 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return vec2(cos(angle), sin(angle));
}

float visibility(vec3 world, vec3 normal) {
    if (shadowed == 0) {
        return 1.0;
    }
    vec4 clip = worldToShadow * vec4(world + shadowLift * normal, 1.0);
    vec3 at = 0.5 * clip.xyz / clip.w + 0.5;
    if (any(greaterThan(abs(at.xy - 0.5), vec2(0.5 + SOFTEST)))) {
        return 1.0;
    }
    float depth = min(at.z, 1.0) - SHADOW_BIAS;
    const float perCount = 1.0 / float(SHADOW_TAPS);
    vec2 first = firstOnDisc();
    float nearer = 0.0;
    float hidden = 0.0;
    vec2 direction = SOFTEST * first;
    for (int tap = 0; tap < SHADOW_TAPS; tap += 2) {
        vec2 off = sqrt((float(tap) + 0.5) * perCount) * direction;
        float above = depth - textureLod(shadowMap, at.xy + off, 0.0).r;
        hidden += above > 0.0 ? 1.0 : 0.0;
        nearer += max(above, 0.0);
        direction = GOLDEN_TURN * (GOLDEN_TURN * direction);
    }
    direction = clamp(PENUMBRA * nearer / max(hidden, 1.0), SHARPEST, SOFTEST) * first;
    float dark = 0.0;
    for (int tap = 0; tap < SHADOW_TAPS; ++tap) {
        vec2 off = sqrt((float(tap) + 0.5) * perCount) * direction;
        dark += textureLod(shadowMap, at.xy + off, 0.0).r < depth ? 1.0 : 0.0;
        direction = GOLDEN_TURN * direction;
    }
    return 1.0 - dark * perCount;
}
