package sunbeam.app.scene;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import sunbeam.app.scene.texture.Body;
import sunbeam.precompute.patch.PatchRequest;

/**
 * Nanostructures of a mesh, and a map of the areas that they cover.
 *
 * @param map absolute image file on the texture coordinates, one color per patch, or {@link Body#NONE} for a single patch
 * @param regions areas, 1 to {@link #MOST}, with distinct colors
 */
public record PatchAtlas(String map, List<Region> regions) {
    /** Patches of one mesh: each has its own tables in graphics memory. */
    public static final int MOST = 8;

    /** Area of a patch with a built-in name, or the absolute name of a descriptor or image. */
    public record Region(SceneColor color, PatchRequest patch) {}

    /** Throws IllegalArgumentException, with a message for the user, for no or too many regions, or two of one color. */
    public PatchAtlas {
        regions = List.copyOf(regions);
        if (regions.isEmpty() || regions.size() > MOST) {
            throw new IllegalArgumentException("has " + regions.size()
                    + " patches beside its map; give each color of the map a patch, such as \"#ff0000\": \"blaze\", at most "
                    + MOST);
        }
        Set<SceneColor> colors = new HashSet<>();
        for (Region region : regions) {
            if (!colors.add(region.color())) {
                throw new IllegalArgumentException(
                        "gives " + region.color() + " two patches; each color of the map has one");
            }
        }
    }

    public static PatchAtlas of(PatchRequest patch) {
        return new PatchAtlas(Body.NONE, List.of(new Region(new SceneColor(Body.WHITE), patch)));
    }

    public boolean isOne() {
        return map.equals(Body.NONE);
    }

    /** Returns the regions' colors in the map, 0xRRGGBB, in order. */
    public List<Integer> colors() {
        return regions.stream().map(region -> region.color().rgb()).toList();
    }
}
