package sunbeam.app.scene.texture;

/**
 * What a mesh wears beside its nanostructure. Shared, not copied.
 *
 * @param colors its texture
 * @param scales which
 * @param relief their relief, by {@link ScaleRelief}
 */
public record Body(BodyTexture colors, Scales scales, BodyTexture relief) {

    /**
     * Loads or makes both.
     *
     * @throws sunbeam.app.files.input.InputException if the texture cannot be used
     */
    public static Body load(String texture, Scales scales) {
        return new Body(BodyTextures.load(texture), scales, ScaleRelief.of(scales));
    }
}
