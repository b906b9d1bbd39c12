package sunbeam.app.scene;

import static sunbeam.app.scene.SceneSettings.GROUND;
import static sunbeam.app.scene.SceneSettings.SHADOWS;
import static sunbeam.app.scene.SceneSettings.SKY;

import java.util.Optional;
import sunbeam.precompute.setting.Choices;

/**
 * Surroundings of a mesh that affect its light.
 *
 * @param ground color of the plane under the mesh; empty for none
 * @param sky radiance of the sky's zenith, which gloss reflects, relative to white under the light
 * @param shadows whether the light casts shadows
 */
public record Surroundings(Optional<SceneColor> ground, double sky, boolean shadows) {
    /** No surroundings, as in the thesis. */
    public static final Surroundings NONE = new Surroundings(Optional.empty(), 0, false);

    static Surroundings of(Choices choices) {
        return new Surroundings(choices.get(GROUND), choices.get(SKY), choices.get(SHADOWS));
    }

    /** True if ambient light depends on the visible share of the sky. */
    public boolean occludesSky() {
        return sky > 0 || ground.isPresent();
    }
}
