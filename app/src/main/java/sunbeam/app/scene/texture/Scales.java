package sunbeam.app.scene.texture;

/** Scales of the built-in snake. */
public enum Scales {
    NONE(0, 0),
    /** A sunbeam snake's: broad and smooth. */
    SMOOTH(15, 0),
    /** A rat snake's: narrower, keeled on the back. */
    KEELED(21, 0.03);

    // Along a unit of u, for each row: scales of the snake's body (SnakeBody) keep their shape from its middle to its
    // tail.
    private static final double PER_UNIT_AND_ROW = 15.3;

    private final int rows;
    private final double keel;

    Scales(int rows, double keel) {
        this.rows = rows;
        this.keel = keel;
    }

    /** Around the body, without the belly's shields. */
    public int rows() {
        return rows;
    }

    /** Along a unit of u behind the head: such that a scale of the snake's body is {@link ScaleRelief#LENGTH} widths of a row long. */
    public double perUnit() {
        return PER_UNIT_AND_ROW * rows;
    }

    /** In widths of a row. */
    double keel() {
        return keel;
    }
}
