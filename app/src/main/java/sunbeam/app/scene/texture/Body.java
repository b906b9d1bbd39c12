package sunbeam.app.scene.texture;

import java.util.Set;
import sunbeam.app.files.cache.BlobCache;

/**
 * Textures of a mesh: colors, scales, and the directions and places of its nanostructure. Shared, not copied.
 *
 * @param colors its texture
 * @param scales which
 * @param relief their relief, by {@link ScaleRelief}
 * @param directions of the nanostructure, by {@link OrientationMap}
 * @param patches by {@link PatchMap}
 * @param patchColor of the patch in question there, 0xRRGGBB
 */
public record Body(
        BodyTexture colors,
        Scales scales,
        BodyTexture relief,
        BodyTexture directions,
        BodyTexture patches,
        int patchColor) {

    /** With the mesh's own tangents, and one patch everywhere. */
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
     * Loads or makes them, with one patch everywhere.
     *
     * @param kept where built-in ones are from earlier runs
     * @throws sunbeam.app.files.input.InputException if texture or orientation map cannot be used
     */
    public static Body load(String texture, Scales scales, String orientationMap, BlobCache kept) {
        Body plain = new Body(BodyTextures.load(texture, kept), scales, ScaleRelief.of(scales, kept));
        return new Body(
                plain.colors,
                scales,
                plain.relief,
                OrientationMap.load(orientationMap),
                plain.patches,
                plain.patchColor);
    }

    /** The same with a patch where a map has its color alone. */
    public Body with(BodyTexture map, int color) {
        return new Body(colors, scales, relief, directions, map, color);
    }
}
