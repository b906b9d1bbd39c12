package sunbeam.precompute.scan.format;

/** The surface that tests write in every format: asymmetric, not square, in whole nanometers. */
final class TestField {
    static final int COLUMNS = 7;
    static final int ROWS = 5;
    static final double WIDTH = 3.5e-6;
    static final double HEIGHT = 2e-6;

    private TestField() {}

    /** Nanometers, row 0 the top. */
    static int nanometers(int column, int row) {
        return 100 * row + column * column - 150;
    }

    /** Meters, row by row from the top. */
    static double[] meters() {
        double[] meters = new double[COLUMNS * ROWS];
        for (int i = 0; i < meters.length; i++) {
            meters[i] = 1e-9 * nanometers(i % COLUMNS, i / COLUMNS);
        }
        return meters;
    }

    interface Visitor {
        void visit(int nanometers);
    }

    /** From the top row. */
    static void downwards(Visitor visitor) {
        for (int row = 0; row < ROWS; row++) {
            along(row, visitor);
        }
    }

    /** From the bottom row. */
    static void upwards(Visitor visitor) {
        for (int row = ROWS - 1; row >= 0; row--) {
            along(row, visitor);
        }
    }

    private static void along(int row, Visitor visitor) {
        for (int column = 0; column < COLUMNS; column++) {
            visitor.visit(nanometers(column, row));
        }
    }
}
