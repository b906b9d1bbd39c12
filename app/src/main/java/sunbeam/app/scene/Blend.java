package sunbeam.app.scene;

import static sunbeam.app.scene.SceneSettings.AMBIENT;
import static sunbeam.app.scene.SceneSettings.BODY_ALPHA;
import static sunbeam.app.scene.SceneSettings.DIFFRACTION;
import static sunbeam.app.scene.SceneSettings.DIFFUSE;
import static sunbeam.app.scene.SceneSettings.TEXTURE_WEIGHT;

import java.util.Optional;
import sunbeam.precompute.setting.Choices;

/**
 * Weights of the blend of diffracted light and body color (thesis algorithm 3.4; shaders/include/blend.glsl).
 *
 * @param diffraction factor of the diffracted light; the thesis's gain. The model's relative radiance is 1 for a flat mirror, and a skin
 *     spreads the same light over the hemisphere, so that factors well above 1 are usual
 * @param texture factor of the body's texture
 * @param diffuse factor of the body's Lambert reflection of the light
 * @param ambient radiance of the ambient light, relative to white
 * @param alpha opacity over the body; empty for the method's default
 */
public record Blend(double diffraction, double texture, double diffuse, double ambient, Optional<BodyAlpha> alpha) {
    public static Blend of(Choices choices) {
        return new Blend(
                choices.get(DIFFRACTION),
                choices.get(TEXTURE_WEIGHT),
                choices.get(DIFFUSE),
                choices.get(AMBIENT),
                choices.find(BODY_ALPHA));
    }

    /** Returns the settings of this blend, the inverse of {@link #of}. */
    public Choices choices() {
        Choices weights = Choices.none()
                .with(DIFFRACTION, diffraction)
                .with(TEXTURE_WEIGHT, texture)
                .with(DIFFUSE, diffuse)
                .with(AMBIENT, ambient);
        return alpha.map(chosen -> weights.with(BODY_ALPHA, chosen)).orElse(weights);
    }

    public boolean hasBody() {
        return texture > 0 && (diffuse > 0 || ambient > 0);
    }

    public Blend withoutBody() {
        return new Blend(diffraction, 0, 0, 0, alpha);
    }
}
