// Patch map (sunbeam.app.scene.texture.Body): the color of the nearest texel selects the patch of a point.
uniform sampler2D patchMap;
// Color of the patch that is drawn: 65536 red + 256 green + blue, each from 0 to 255.
uniform float patchColor;

float patchColorHere() {
    ivec2 size = textureSize(patchMap, 0);
    ivec2 texel = min(ivec2(fract(surfaceCoordinate) * vec2(size)), size - 1);
    return dot(floor(255.0 * texelFetch(patchMap, texel, 0).rgb + 0.5), vec3(65536.0, 256.0, 1.0));
}
