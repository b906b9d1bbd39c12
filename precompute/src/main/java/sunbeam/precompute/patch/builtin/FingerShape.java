package sunbeam.precompute.patch.builtin;

/**
 * Shape of the plate of a row of fingers. Its upper edge is toothed; it lies on the plate of the row above and dives under the row below.
 * Heights are in meters above the mean surface.
 *
 * <p>Let t be 0 at the tips and 1 where the next row begins, phi 0 on a finger's ridge and 1 midway to its neighbor. The edge is at t =
 * length (1 - (1 - phi^tipExponent)^baseExponent).
 *
 * @param length distance from the tips to the bottom of the notches between them, as a fraction of the rows' distance
 * @param tipExponent exponent; small: pointed tips; large: blunt ones
 * @param baseExponent exponent; large: notches that close slowly, like a narrow V
 * @param crest height of the ridge at the tip
 * @param fall drop of the ridge until the next row begins
 * @param bulge arch of the ridge between its ends
 * @param dome depth of a finger's flank below its ridge
 * @param fade decay length of fingers under the next row, as a fraction of the rows' distance
 * @param floor height of the ground between the fingers where the plate dives under the next row
 * @param floorFall further drop of this ground until the end of the plate
 * @param notchDepth additional depth of the ground at the bottom of the notches
 * @param notchLength decay length of that depth, meters
 * @param edgeWidth standard deviation in meters of the slope that rounds the edges (the probe's tip)
 */
record FingerShape(
        double length,
        double tipExponent,
        double baseExponent,
        double crest,
        double fall,
        double bulge,
        double dome,
        double fade,
        double floor,
        double floorFall,
        double notchDepth,
        double notchLength,
        double edgeWidth) {

    /** Returns the height of the uncovered plate, phi and t in [0, 1]. */
    double top(double phi, double t) {
        double inFinger = Math.min(1, phi / halfWidth(t / length));
        return crest - fall * t + 4 * bulge * t * (1 - t) - dome * inFinger * inFinger;
    }

    /** Returns the height of the plate under the fingers of the next row, at their t: from {@code top(phi, 1)} down to the floor. */
    double under(double phi, double t) {
        return (top(phi, 1) - floor) * Math.exp(-t / fade) + floor - floorFall * t;
    }

    /** Returns the additional depth of the ground at a distance in meters above a notch's bottom. */
    double notch(double distance) {
        return notchDepth * Math.exp(-Math.max(0, distance) / notchLength);
    }

    double edge(double phi) {
        return 1 - Math.pow(1 - Math.pow(phi, tipExponent), baseExponent);
    }

    /** Inverse of {@link #edge}: half the width of a finger, as a value of phi. */
    private double halfWidth(double position) {
        return position >= 1
                ? 1
                : Math.max(0.1, Math.pow(1 - Math.pow(1 - position, 1 / baseExponent), 1 / tipExponent));
    }
}
