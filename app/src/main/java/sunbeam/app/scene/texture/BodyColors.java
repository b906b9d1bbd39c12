package sunbeam.app.scene.texture;

/** The color of a snake's body, place by place. */
interface BodyColors {

    /**
     * Linear light, each channel 0 to 1.
     *
     * @param along 0 at the snout, 1 at the tip of the tail
     * @param around -1 and 1 in the middle of the belly, 0 on the back
     */
    LinearRgb at(double along, double around);

    /** 0 up to {@code from}, 1 beyond {@code to}, smooth between. */
    static double step(double from, double to, double value) {
        double t = Math.min(1, Math.max(0, (value - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }
}
