package sunbeam.app.scene.texture;

/**
 * What a mesh wears beside its nanostructure. Shared, not copied.
 *
 * @param colors its texture
 * @param scales which
 * @param relief their relief, by {@link ScaleRelief}
 * @param directions of the nanostructure, by {@link OrientationMap}
 */
public record Body(BodyTexture colors, Scales scales, BodyTexture relief, BodyTexture directions) {

    /** With the mesh's own tangents. */
    public Body(BodyTexture colors, Scales scales, BodyTexture relief) {
        this(colors, scales, relief, OrientationMap.load(OrientationMap.NONE));
    }

    /** As {@link #load(String, Scales, String)}, with the mesh's own tangents. */
    public static Body load(String texture, Scales scales) {
        return load(texture, scales, OrientationMap.NONE);
    }

    /**
     * Loads or makes them.
     *
     * @throws sunbeam.app.files.input.InputException if texture or orientation map cannot be used
     */
    public static Body load(String texture, Scales scales, String orientationMap) {
        return new Body(
                BodyTextures.load(texture), scales, ScaleRelief.of(scales), OrientationMap.load(orientationMap));
    }
}
