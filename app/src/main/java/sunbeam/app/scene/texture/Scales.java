package sunbeam.app.scene.texture;

/** The scales of the built-in snake. */
public enum Scales {
    /** Smooth skin. */
    NONE(0, 0),
    /** A sunbeam snake's scales: broad and smooth, in 15 rows. */
    SMOOTH(15, 0),
    /** A rat snake's scales: narrower, in 21 rows, keeled on the back. */
    KEELED(21, 0.03);

    private final int rows;
    private final double keel;

    Scales(int rows, double keel) {
        this.rows = rows;
        this.keel = keel;
    }

    /** Returns the number of rows around the body, without the belly's shields; 0 for no scales. */
    public int rows() {
        return rows;
    }

    /** Returns the height of the keels in widths of a row. */
    double keel() {
        return keel;
    }
}
