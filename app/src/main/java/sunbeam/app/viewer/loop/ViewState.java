package sunbeam.app.viewer.loop;

import java.util.Optional;
import sunbeam.app.scene.SceneData;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.optics.Direction;

/**
 * What the window is to show.
 *
 * @param scene with its tables
 * @param width pixels per row
 * @param height rows
 * @param mapLight towards the light of the BRDF map, tangent frame; empty while no map is shown
 * @param mapRegion number of the patch that it is of, among the scene's
 * @param isOther whether it is the other of two methods, beside the scene's own; without a map
 */
public record ViewState(
        LoadedScene scene, int width, int height, Optional<Direction> mapLight, int mapRegion, boolean isOther) {
    /** The same view of the scene by another method. */
    public ViewState by(LoadedScene other) {
        return new ViewState(other, width, height, Optional.empty(), 0, true);
    }

    public SceneData fine() {
        return scene.fine();
    }

    /** Whether only the BRDF map may differ, as after a pick. */
    @SuppressWarnings("ReferenceEquality") // the same object as long as nothing has changed
    boolean showsThePictureOf(ViewState other) {
        return isOther == other.isOther && fine() == other.fine() && width == other.width && height == other.height;
    }
}
