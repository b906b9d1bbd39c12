#version 330 core
#define SHADOW_TAPS 8
// Mip levels finer by this, since a pixel is the mean of samples.
uniform float texelBias;
#define TEXEL_BIAS texelBias
#include "include/relief.glsl"
#include "include/blend.glsl"
#include "include/display.glsl"
#include "include/gain.glsl"
#include "include/shadow.glsl"
#include "include/sky.glsl"
#include "sunbeam.glsl"

// A scene's skin in one pass, sRGB: four look-ups of the table for each light.

uniform sampler2D bodyTexture;
uniform float tabulatedSlopeVariance;
// The same of relief that is not in the table.
uniform float slopeVariance;
// 1 to write what the pointer asks for, instead of the color: cosines of light and view to the normal, and that between them, 0 to 1.
uniform int probe;

layout(location = 0) out vec4 color;

// Mip level whose texels are as wide as the mean axis of a pixel's footprint, with relief and light.
float footprintLevel(vec3 uvw, vec3 du, vec3 dv, vec3 wi, float lightVariance) {
    float variance = (dot(du.xy, du.xy) + dot(dv.xy, dv.xy)) / 24.0 + 0.5 * lightVariance * (1.0 + wi.z * wi.z)
            + slopeVariance * uvw.z * uvw.z;
    return min(0.5 * log2(1.0 + 12.0 * variance / (SUNBEAM_STEP * SUNBEAM_STEP)), SUNBEAM_COARSEST);
}

void main() {
    vec4 relief = reliefTexel();
    mat3 frame = tangentFrameAbout(reliefNormal(relief.xy), patchTurn());
    vec3 wr = viewDirection(frame);
    float seen = visibleSky();
    vec3 albedo = belowGloss(wr, seen) * (LINEAR_SRGB_TO_XYZ * skinAlbedo(relief, texelAt(bodyTexture, surfaceCoordinate).rgb));
    float ambient = skyShare(frame[2], seen);
    vec3 gloss = glossXyz(frame, wr, seen);
    vec3 sum = vec3(0.0);
    for (int group = 0; group < lightGroups; ++group) {
        vec4 lights = lightTexel(group, GROUP_LIGHTS);
        float visible = visibility(group, worldPosition, frame[2], gl_FragCoord.xy);
        for (int light = int(lights.x); light < int(lights.y); ++light) {
            vec4 towards = lightTexel(light, LIGHT_TOWARDS);
            vec3 wi = towards.xyz * frame;
            vec3 uvw = diffractionVector(wi, wr);
            vec3 du = dFdx(uvw);
            vec3 dv = dFdy(uvw);
            vec3 diffracted = vec3(0.0);
            if (diffractionWeight != 0.0 && wi.z > 0.0 && wr.z > 0.0) {
                ReliefMean mean = reliefMean(wi, wr, tabulatedSlopeVariance + slopeVariance);
                diffracted = mean.gain * sunbeamPower(mean.uvw, footprintLevel(mean.uvw, du, dv, wi, towards.w));
            }
            float reflectance = schlickReflectance(halfAngleCosine(wi, wr));
            vec3 xyz = blended(visible * diffracted, albedo, visible * wi.z, reflectance, ambient);
            xyz += visible * lightGloss(wi, wr, seen) * (LINEAR_SRGB_TO_XYZ * vec3(1.0));
            sum += lightTexel(light, LIGHT_COLOR).rgb * (XYZ_TO_LINEAR_SRGB * xyz);
        }
    }
    color = vec4(srgbCurve(displayLight(LINEAR_SRGB_TO_XYZ * sum + gloss)), 1.0);
    if (probe == 1) {
        vec3 wi = lightTexel(0, LIGHT_TOWARDS).xyz * frame;
        color = vec4(0.5 + 0.5 * vec3(wi.z, wr.z, dot(wi, wr)), 1.0);
    }
}
