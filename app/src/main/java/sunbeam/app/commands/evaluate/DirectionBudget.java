package sunbeam.app.commands.evaluate;

import sunbeam.precompute.optics.CoherenceWindow;

/**
 * How many directions a response takes where the user does not say: as many as a processor computes in half a minute or so. A
 * direction sums the DFT bins that the window reaches, whose number grows with the scan's area.
 *
 * @param width of the surface, metres
 * @param height of the surface, metres
 */
record DirectionBudget(double width, double height, CoherenceWindow window) {
    // Bins times directions. Of 10 to 20 terms each, at 2 to 5 ns: 20 to 60 s of processor time.
    private static final double MOST = 6e7;
    // Deviations of the window's spectrum on each side that the standard tolerance takes.
    private static final double REACH = 3;

    /**
     * One choice.
     *
     * @param stepNm between wavelengths
     * @param angles of the viewer
     */
    record Rung(int stepNm, int angles) {}

    /** From all to the fewest that still show a ridge. */
    static final Rung[] LADDER = {
        new Rung(1, 1500),
        new Rung(2, 1500),
        new Rung(4, 1500),
        new Rung(5, 1000),
        new Rung(10, 750),
        new Rung(10, 400),
        new Rung(20, 300),
        new Rung(20, 150)
    };

    /** Whether so many directions are computed in time. */
    boolean holds(long directions) {
        return bins(width) * bins(height) * directions <= MOST;
    }

    private double bins(double side) {
        return 1 + 2 * Math.ceil(REACH * window.sigmaFrequency() * side);
    }
}
