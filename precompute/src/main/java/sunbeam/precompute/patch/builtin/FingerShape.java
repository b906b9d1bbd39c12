package sunbeam.precompute.patch.builtin;

/**
 * The plate that a row of fingers is: its upper edge is toothed, it lies on the plate of the row above and dives under
 * the row below. Heights in meters against the mean surface.
 *
 * <p>With t = 0 at the tips and t = 1 where the next row begins, and phi = 0 on a finger's ridge and 1 midway to its
 * neighbor, the edge is at t = length (1 - (1 - phi^tipExponent)^baseExponent).
 *
 * @param length from the tips to the bottom of the notches between them, as a fraction of the rows' distance
 * @param tipExponent small: pointed tips; large: blunt ones
 * @param baseExponent large: notches that close slowly, like a narrow V
 * @param crest height of the ridge at the tip
 * @param fall by how much the ridge drops until the next row begins
 * @param bulge by how much the ridge arches between
 * @param dome by how much a finger's flank is lower than its ridge
 * @param fade distance over which fingers vanish under the next row, as a fraction of the rows' distance
 * @param floor height of the ground between the fingers where the plate dives under the next row
 * @param floorFall further drop of this ground until its end
 * @param notchDepth by how much the ground is deeper yet at the bottom of the notches
 * @param notchLength distance in meters over which it gets so deep
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

    /** Height of the plate where nothing covers it, phi and t in [0, 1]. */
    double top(double phi, double t) {
        double inFinger = Math.min(1, phi / halfWidth(t / length));
        return crest - fall * t + 4 * bulge * t * (1 - t) - dome * inFinger * inFinger;
    }

    /** Height of the plate at t of the next row, under its fingers: from {@code top(phi, 1)} down to the floor. */
    double under(double phi, double t) {
        return (top(phi, 1) - floor) * Math.exp(-t / fade) + floor - floorFall * t;
    }

    /** How much deeper the ground is at a distance in meters from a notch's bottom; towards it, that is up, positive. */
    double notch(double distance) {
        return notchDepth * Math.exp(-Math.max(0, distance) / notchLength);
    }

    /** The edge's position t / length, for phi in [0, 1]. */
    double edge(double phi) {
        return 1 - Math.pow(1 - Math.pow(phi, tipExponent), baseExponent);
    }

    /** The inverse of {@link #edge}: half the width of a finger, for a position in [0, 1] and beyond. */
    private double halfWidth(double position) {
        return position >= 1
                ? 1
                : Math.max(0.1, Math.pow(1 - Math.pow(1 - position, 1 / baseExponent), 1 / tipExponent));
    }
}
