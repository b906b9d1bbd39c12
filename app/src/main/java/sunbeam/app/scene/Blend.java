package sunbeam.app.scene;

/**
 * Weights of the blend of diffracted light and body colour (thesis algorithm 3.4; shaders/include/blend.glsl).
 *
 * @param diffraction factor of the diffracted light; the thesis's gain. The model's relative radiance is 1 for a flat
 *     mirror, and a skin spreads the same light over the hemisphere, so that factors well above 1 are usual
 * @param texture factor of the body's texture
 * @param diffuse share of the light's Lambert reflection on the body
 * @param ambient share of light that reaches the body from everywhere
 */
public record Blend(double diffraction, double texture, double diffuse, double ambient) {
    /** Weights beyond this are slips. */
    public static final double LARGEST = 1e9;

    /** Rejects negative weights and those that are no numbers. */
    public Blend {
        check("diffraction", diffraction);
        check("texture", texture);
        check("diffuse", diffuse);
        check("ambient", ambient);
    }

    /** The same with another factor of the diffracted light. */
    public Blend withDiffraction(double weight) {
        return new Blend(weight, texture, diffuse, ambient);
    }

    /** The diffracted light alone. */
    Blend withoutBody() {
        return new Blend(diffraction, 0, 0, 0);
    }

    private static void check(String name, double weight) {
        if (!(weight >= 0 && weight <= LARGEST)) {
            throw new IllegalArgumentException("weight " + name + " " + weight + " is out of range; give 0 to 1e9");
        }
    }
}
