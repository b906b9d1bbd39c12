package sunbeam.app.scene.texture;

/** Soft thresholds. */
final class Steps {
    private Steps() {}

    /** 0 up to {@code from}, 1 beyond {@code to}, smooth between. */
    static double smooth(double from, double to, double value) {
        double t = Math.min(1, Math.max(0, (value - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }
}
