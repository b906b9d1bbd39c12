package sunbeam.app.scene.texture;

/** Scales of the built-in snake. */
public enum Scales {
    NONE(0, 0),
    /** A sunbeam snake's: broad and smooth. */
    SMOOTH(15, 0),
    /** A rat snake's: narrower, keeled on the back. */
    KEELED(21, 0.03);

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

    /** In widths of a row. */
    double keel() {
        return keel;
    }
}
