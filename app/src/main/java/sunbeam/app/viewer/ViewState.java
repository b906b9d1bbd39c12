package sunbeam.app.viewer;

import java.util.List;
import java.util.Optional;
import sunbeam.app.scene.SceneData;
import sunbeam.precompute.optics.Direction;

/**
 * What the window is to show.
 *
 * @param parts the scene with its full plan, of each part of the skin's light
 * @param coarse the same scene with a plan for previews
 * @param moving the same scene with tables by which what moves is drawn; empty where its own are, or there are none
 * @param mapped the same scene with what the BRDF map is drawn by, where its own tables have none
 * @param width pixels per row
 * @param height rows
 * @param mapLight towards the light of the BRDF map, tangent frame; empty while no map is shown
 */
record ViewState(
        List<SceneData> parts,
        SceneData coarse,
        Optional<SceneData> moving,
        Optional<SceneData> mapped,
        int width,
        int height,
        Optional<Direction> mapLight) {

    /** What all parts share, and the first one's plan. */
    SceneData fine() {
        return parts.get(0);
    }

    /** Whether what is coarse shows the body alone, until there are colors. */
    boolean isBare() {
        return coarse.scene().blend().diffraction() == 0
                && fine().scene().blend().diffraction() > 0;
    }

    /** Whether only the BRDF map may differ, as after a pick. */
    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing has changed
    boolean showsThePictureOf(ViewState other) {
        return fine() == other.fine() && coarse == other.coarse && width == other.width && height == other.height;
    }
}
