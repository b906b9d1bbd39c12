package sunbeam.precompute.cause;

/**
 * A wavelength at which a plan's shader looks.
 *
 * @param wavelength metres
 * @param weights of X, Y, Z
 * @param place where it looks
 */
record PlanNode(double wavelength, double[] weights, Place place) {

    /** What is looked at of the windowed spectrum. */
    sealed interface Place {}

    /** Any place, along both axes as the plan has it. */
    record Anywhere() implements Place {}

    /** A column of a grid, met exactly, or a row. */
    record OnLine(boolean exactX) implements Place {}

    /** One bin alone. */
    record OneOrder(int binX, int binY) implements Place {}
}
