package sunbeam.app.commands.sample;

/**
 * A column of the rows.
 *
 * @param name of the array
 * @param width numbers a row
 * @param values of rows
 */
record RowColumn(String name, int width, Values values) {
    /** Rows that are made at once. */
    static final int BATCH = 1 << 21;

    /** What stands in the column. */
    @FunctionalInterface
    interface Values {
        /** Of some rows, one after the other. */
        float[] of(long firstRow, int rows);
    }
}
