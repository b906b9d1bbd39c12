// For comparison only: a white disc that sends the same light into every direction (Lambert, Photometria, 1760).

// CIE XYZ of the light.
uniform vec3 lambertWhite;

vec3 diffractedXyz(vec3 uvw) {
    return lambertWhite;
}
