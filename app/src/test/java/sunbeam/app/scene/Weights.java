package sunbeam.app.scene;

import sunbeam.precompute.setting.Choices;

public final class Weights {
    private Weights() {}

    /** Weights of diffracted light, of the body's texture, of its diffuse reflection and of ambient light. */
    public static Choices of(double diffraction, double texture, double diffuse, double ambient) {
        return Choices.none()
                .with(SceneSettings.DIFFRACTION, diffraction)
                .with(SceneSettings.TEXTURE_WEIGHT, texture)
                .with(SceneSettings.DIFFUSE, diffuse)
                .with(SceneSettings.AMBIENT, ambient);
    }
}
