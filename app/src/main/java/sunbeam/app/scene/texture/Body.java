package sunbeam.app.scene.texture;

import java.util.Set;
import sunbeam.app.files.cache.BlobCache;

/**
 * Textures of a mesh: colors, scales, directions and places of its nanostructure. Arrays are shared, not copied.
 *
 * @param relief relief of the scales, encoded by {@link ScaleRelief}
 * @param directions directions of the nanostructure, encoded by {@link OrientationMap}
 * @param patches map of the patches, encoded by {@link PatchMap}
 * @param patchColor color of this body's patch in that map, 0xRRGGBB
 */
public record Body(
        BodyTexture colors,
        Scales scales,
        BodyTexture relief,
        BodyTexture directions,
        BodyTexture patches,
        int patchColor) {

    public Body(BodyTexture colors, Scales scales, BodyTexture relief) {
        this(
                colors,
                scales,
                relief,
                OrientationMap.load(OrientationMap.NONE),
                PatchMap.load(PatchMap.NONE, Set.of()),
                PatchMap.WHITE);
    }

    /**
     * Loads or generates the textures, with one patch everywhere.
     *
     * @throws sunbeam.app.files.input.InputException if texture or orientation map cannot be used
     */
    public static Body load(String texture, Scales scales, String orientationMap, BlobCache cache) {
        Body plain = new Body(BodyTextures.load(texture, cache), scales, ScaleRelief.of(scales, cache));
        return new Body(
                plain.colors,
                scales,
                plain.relief,
                OrientationMap.load(orientationMap),
                plain.patches,
                plain.patchColor);
    }

    public Body with(BodyTexture map, int color) {
        return new Body(colors, scales, relief, directions, map, color);
    }
}
