package sunbeam.app.scene;

import java.util.List;
import sunbeam.precompute.setting.Choices;

/**
 * One thing of a scene: a mesh, its nanostructure and its place.
 *
 * @param settings values of {@link SceneSettings#OF_OBJECT}
 */
public record SceneObject(Choices settings, PatchAtlas patches, Placement placement) {
    /** Each object has its own textures, and each look its own tables in graphics memory. */
    public static final int MOST = 64;

    private static final Choices STANDARD = SceneSettings.standards(SceneSettings.OF_OBJECT);

    public SceneObject {
        settings = settings.only(SceneSettings.OF_OBJECT).over(STANDARD);
    }

    /** Returns a value that is equal for objects that differ in mesh, textures, directions and place alone: one pass shades them. */
    List<Object> look() {
        return List.of(patches, settings.only(SceneSettings.OF_LOOK));
    }
}
