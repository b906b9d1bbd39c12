package sunbeam.precompute.patch.builtin;

/**
 * Where the fingers of a {@link FingerSkin} stand and how far they stray from a lattice. Fingers point up (+y); rows
 * are counted downwards.
 *
 * @param rows number of rows in the patch, at least 3
 * @param fingers mean number of fingers in a row, at least 3
 * @param rowSpread standard deviation of the distance between rows, as a fraction of its mean
 * @param fingerSpread standard deviation of the distance between neighboring fingers of a row, as a fraction of its
 *     mean; deviations add up along the row, so order is lost over long distances
 * @param coherenceRows over how many rows (standard deviation of a Gaussian) the columns of fingers continue; 0 makes
 *     the rows independent, each with a random offset and a number of fingers that varies by {@code countSpread}
 * @param countSpread standard deviation of the number of fingers between rows; only for {@code coherenceRows} 0
 * @param wander root mean square in metres by which the lines of the rows meander together
 * @param wanderModesX most periods of the meander along x
 * @param wanderModesY most periods of the meander along y: few keep neighboring rows parallel
 * @param tipSpread standard deviation in metres of single tips off their row's line
 * @param heightSpread standard deviation in metres of the height of single fingers
 * @param lean by how much a finger moves to +x per distance downwards
 */
record RowLayout(
        int rows,
        int fingers,
        double rowSpread,
        double fingerSpread,
        double coherenceRows,
        double countSpread,
        double wander,
        int wanderModesX,
        int wanderModesY,
        double tipSpread,
        double heightSpread,
        double lean) {}
