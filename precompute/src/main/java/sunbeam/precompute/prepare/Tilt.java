package sunbeam.precompute.prepare;

import sunbeam.precompute.optics.HeightMap;

/**
 * The plane in a scan.
 *
 * @param rise of the plane from its lowest corner to its highest, metres
 * @param share of the heights' variance that is the plane's, 0..1
 */
public record Tilt(double rise, double share) {
    /** Of a level scan. */
    public static final Tilt NONE = new Tilt(0, 0);

    /** Of heights, of which some may be missing. */
    public static Tilt of(HeightMap field) {
        Polynomial plane = Polynomial.fit(field, 3);
        double all = Polynomial.fit(field, 1).variance();
        double rest = plane.variance();
        return new Tilt(plane.rise(), all > 0 ? Math.max(0, 1 - rest / all) : 0);
    }
}
