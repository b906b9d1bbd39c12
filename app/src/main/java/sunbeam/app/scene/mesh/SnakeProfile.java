package sunbeam.app.scene.mesh;

/**
 * The snake's outline: half width and half height of its cross-sections, as functions of the place along the body (0
 * snout, 1 tip of the tail).
 */
final class SnakeProfile {
    /** Largest half width of the body, meters. */
    static final double RADIUS = 0.013;

    /** Place along the body where the head ends and the neck begins. */
    static final double NECK = 0.045;

    // Squared half width of the head over the place, in RADIUS^2. It grows linearly from the snout, which makes a
    // round end. The neck has 80 % of the width of the wedge-shaped head.
    private final Curve squaredHead = new Curve(
            -0.0035, -0.22, 0, 0, 0.0035, 0.22, 0.0105, 0.44, 0.021, 0.64, 0.0275, 0.61, 0.0345, 0.49, NECK, 0.41);
    // Half width over the place, in RADIUS. The point beyond the tip keeps the tail a cone.
    private final Curve body = new Curve(
            NECK, 0.64, 0.11, 0.68, 0.25, 0.88, 0.42, 1, 0.58, 0.98, 0.76, 0.72, 0.9, 0.34, 1, 0.05, 1.1, -0.24);
    // Ratio of height to width over the place: a flat head, a round neck, a body that sags a little.
    private final Curve flatness = new Curve(0, 0.72, 0.0225, 0.62, NECK, 0.86, 0.2, 0.9, 0.8, 0.92, 1, 1);

    double halfWidth(double place) {
        double relative = place < NECK ? Math.sqrt(squaredHead.at(place)) : body.at(place);
        return RADIUS * relative;
    }

    /** Returns the height of the back above the center line, meters. */
    double halfHeight(double place) {
        return halfWidth(place) * flatness.at(place);
    }

    /** Returns the depth of the belly, which is flatter than the back, below the center line, meters. */
    double bellyDepth(double place) {
        return 0.82 * halfHeight(place);
    }
}
