package sunbeam.app.scene;

import static sunbeam.app.scene.SceneSettings.GROUND;
import static sunbeam.app.scene.SceneSettings.SHADOWS;
import static sunbeam.app.scene.SceneSettings.SKY;

import java.util.Optional;
import sunbeam.precompute.setting.Choices;

/**
 * What is around a mesh and shapes its light.
 *
 * @param ground color of the plane on which it lies; empty for none
 * @param sky radiance of the sky's zenith, which gloss reflects, in that of white under the light
 * @param shadows whether what the light does not reach is dark
 */
public record Surroundings(Optional<SceneColor> ground, double sky, boolean shadows) {
    /** Nothing, as in the thesis. */
    public static final Surroundings NONE = new Surroundings(Optional.empty(), 0, false);

    static Surroundings of(Choices choices) {
        return new Surroundings(choices.get(GROUND), choices.get(SKY), choices.get(SHADOWS));
    }

    /** Whether light from everywhere is less where little of the sky is seen. */
    public boolean occludesSky() {
        return sky > 0 || ground.isPresent();
    }
}
