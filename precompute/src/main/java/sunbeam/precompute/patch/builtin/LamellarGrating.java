package sunbeam.precompute.patch.builtin;

import sunbeam.precompute.optics.HeightMap;

/**
 * Rectangular ridges. With a ridge of half the period the even orders but 0 vanish; with depth = lambda / 4 the mirror
 * direction is dark at the normal.
 *
 * @param grid period and samples
 * @param depth height of the ridges over the grooves in metres
 * @param ridge the ridge's part of the period, between 0 and 1; should be a whole number of columns
 */
public record LamellarGrating(GratingGrid grid, double depth, double ridge) {
    public LamellarGrating {
        Parameters.requirePositive("depth", depth);
        if (!(ridge > 0 && ridge < 1)) {
            throw new IllegalArgumentException("ridge must lie between 0 and 1, got " + ridge);
        }
    }

    /** 2.5 um period as the blazed grating's, ridges half of it and 137.5 nm high: dark in the mirror at 550 nm. */
    static LamellarGrating standard() {
        return new LamellarGrating(GratingGrid.ofPeriod(2.5e-6), 137.5e-9, 0.5);
    }

    /** One period: the ridge on the left, the groove (height 0) on the right. */
    public HeightMap generate() {
        return grid.sample(place -> place < ridge ? depth : 0);
    }
}
