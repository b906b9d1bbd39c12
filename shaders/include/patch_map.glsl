// Patch map (sunbeam.app.scene.texture.Body): red of the nearest texel is the index of the patch in its object.
uniform sampler2D patchMap;

float patchHere() {
    ivec2 size = textureSize(patchMap, 0);
    ivec2 texel = min(ivec2(fract(surfaceCoordinate) * vec2(size)), size - 1);
    return floor(255.0 * texelFetch(patchMap, texel, 0).r + 0.5);
}
