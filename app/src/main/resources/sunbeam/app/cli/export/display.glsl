// As `sunbeam brdf-map` shows X, Y, Z: exposure, gamut, highlights compressed with their hue, the curve of sRGB.
vec3 display(vec3 xyz, float exposure) {
    float luminance = exposure * xyz.y;
    if (!(luminance > 0.0)) {
        return vec3(0.0);
    }
    vec3 rgb = SUNBEAM_XYZ_TO_REC709 * (exposure * xyz);
    float least = min(0.0, min(rgb.r, min(rgb.g, rgb.b)));
    rgb = luminance / (luminance - least) * (rgb - least);
    float largest = clamp(max(rgb.r, max(rgb.g, rgb.b)), 1e-30, 1e9);
    float peak = largest > 0.5 ? 1.0 - 0.25 / largest : largest;
    float white = 1.0 - 1.0 / (0.005 * (largest - peak) + 1.0);
    rgb = min(peak * mix(rgb / largest, vec3(1.0), white), 1.0);
    return mix(1.055 * pow(max(rgb, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055, 12.92 * rgb, lessThanEqual(rgb, vec3(0.0031308)));
}

// A map of all views, and right of it, or below, a sphere of the material, each in a square; light in the map's frame, or the camera's.
uniform vec3 light;
uniform float exposure;
uniform float side;
uniform bool stacked;
out vec4 color;

vec3 shaded(vec2 disc, bool map) {
    float square = dot(disc, disc);
    if (square >= 1.0) {
        return vec3(0.0);
    }
    vec3 onto = vec3(disc, sqrt(1.0 - square));
    if (map) {
        return sunbeamXyz(light, onto, vec3(0.0), vec3(0.0));
    }
    vec3 tangent = normalize(vec3(onto.z, 0.0, -onto.x));
    mat3 frame = mat3(tangent, cross(onto, tangent), onto);
    return sunbeamXyz(light * frame, vec3(0.0, 0.0, 1.0) * frame, vec3(0.0), vec3(0.0));
}

void main() {
    bool map = stacked ? gl_FragCoord.y > side : gl_FragCoord.x < side;
    vec2 disc = 2.0 * mod(gl_FragCoord.xy, side) / side - 1.0;
    if (map) {
        color = vec4(display(shaded(disc, true), exposure), 1.0);
        return;
    }
    // Four samples a pixel, each as a screen shows it.
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        sum += display(shaded(1.04 * (disc + (vec2(i & 1, i >> 1) - 0.5) / side), false), exposure);
    }
    color = vec4(0.25 * sum, 1.0);
}
