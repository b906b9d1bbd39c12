package sunbeam.app.viewer;

import java.util.Optional;
import sunbeam.app.scene.SceneData;
import sunbeam.precompute.optics.Direction;

/**
 * What the window is to show.
 *
 * @param fine the scene with its full plan
 * @param coarse the same scene with a plan for previews
 * @param mapped the same scene with what the BRDF map is drawn by, where its own tables have none
 * @param width pixels per row
 * @param height rows
 * @param mapLight towards the light of the BRDF map, tangent frame; empty while no map is shown
 */
record ViewState(
        SceneData fine,
        SceneData coarse,
        Optional<SceneData> mapped,
        int width,
        int height,
        Optional<Direction> mapLight) {

    /** Whether only the BRDF map may differ, as after a pick. */
    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing has changed
    boolean showsThePictureOf(ViewState other) {
        return fine == other.fine && coarse == other.coarse && width == other.width && height == other.height;
    }
}
