package sunbeam.app.viewer.loop;

import sunbeam.app.render.SceneData;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.viewer.model.LoadedScene;

/**
 * Description of the picture that the window shows, by the scene's own method or by the comparison method.
 *
 * @param metering number of times that the user had the exposure metered anew
 */
public record ViewState(LoadedScene scene, int metering, int width, int height, boolean isOther) {
    public SceneData firstPart() {
        return scene.firstPart();
    }

    public boolean showsThePictureOf(ViewState other) {
        return isOther == other.isOther
                && SceneSharing.isSame(firstPart(), other.firstPart())
                && metering == other.metering
                && width == other.width
                && height == other.height;
    }
}
