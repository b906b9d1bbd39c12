package sunbeam.app.viewer.loop;

import java.util.Optional;
import sunbeam.app.render.SceneData;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.optics.Direction;

/**
 * Description of the picture and map that the window shows.
 *
 * @param mapLight direction to the light of the BRDF map, tangent frame; empty if no map is visible
 * @param mapRegion index of the map's patch among the scene's patches
 * @param isOther true for the comparison method, which has no map
 */
public record ViewState(
        LoadedScene scene, int width, int height, Optional<Direction> mapLight, int mapRegion, boolean isOther) {
    public ViewState by(LoadedScene other) {
        return new ViewState(other, width, height, Optional.empty(), 0, true);
    }

    public SceneData firstPart() {
        return scene.firstPart();
    }

    /** True if the states differ at most in the BRDF map, as after a pick. */
    @SuppressWarnings("ReferenceEquality") // unchanged parts keep their objects
    boolean showsThePictureOf(ViewState other) {
        return isOther == other.isOther
                && firstPart() == other.firstPart()
                && width == other.width
                && height == other.height;
    }
}
