package sunbeam.precompute.fault;

/** The frame of a picture that somebody took of a scan on a screen: columns, and rows within the others, of one height all along. */
final class PictureFrame {
    // What is left must be most of the picture: else columns are of one height for another reason.
    private static final double LEAST_SHARE = 0.5;

    private PictureFrame() {}

    /**
     * The columns that a frame leaves: the widest run of which none is of one height, where one at a side is.
     *
     * @param firstRow of those that are looked at
     * @param endRow after the last
     * @return first and end; all where there is no frame
     */
    static int[] columnsWithin(Measured scan, int firstRow, int endRow) {
        int[] all = {0, scan.columns()};
        boolean framed =
                isConstant(scan, 0, firstRow, endRow) || isConstant(scan, scan.columns() - 1, firstRow, endRow);
        if (!framed) {
            return all;
        }
        int[] widest = {0, 0};
        int first = 0;
        for (int column = 0; column <= scan.columns(); column++) {
            if (column == scan.columns() || isConstant(scan, column, firstRow, endRow)) {
                widest = column - first > widest[1] - widest[0] ? new int[] {first, column} : widest;
                first = column + 1;
            }
        }
        return widest[1] - widest[0] >= LEAST_SHARE * scan.columns() ? widest : all;
    }

    /**
     * The rows that a frame leaves of some columns.
     *
     * @return first and end
     */
    static int[] rowsWithin(Measured scan, int[] columns, int firstRow, int endRow) {
        int first = firstRow;
        int end = endRow;
        while (first < end - 1 && isConstantRow(scan, first, columns)) {
            first++;
        }
        while (end > first + 1 && isConstantRow(scan, end - 1, columns)) {
            end--;
        }
        return new int[] {first, end};
    }

    private static boolean isConstantRow(Measured scan, int row, int[] columns) {
        for (int column = columns[0]; column < columns[1]; column++) {
            if (scan.at(column, row) != scan.at(columns[0], row)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isConstant(Measured scan, int column, int firstRow, int endRow) {
        for (int row = firstRow; row < endRow; row++) {
            if (scan.at(column, row) != scan.at(column, firstRow)) {
                return false;
            }
        }
        return true;
    }
}
