package sunbeam.precompute.prepare;

/**
 * The plane in a scan.
 *
 * @param rise of the plane from its lowest corner to its highest, metres
 * @param share of the heights' variance that is the plane's, 0..1
 */
public record Tilt(double rise, double share) {

    /** Of heights, of which some may be missing. */
    public static Tilt of(HeightField field) {
        Polynomial plane = Polynomial.fit(field, 3);
        double all = variance(Polynomial.fit(field, 1).subtracted().heights());
        double rest = variance(plane.subtracted().heights());
        return new Tilt(Math.abs(plane.riseX()) + Math.abs(plane.riseY()), all > 0 ? Math.max(0, 1 - rest / all) : 0);
    }

    private static double variance(double[] heights) {
        double sum = 0;
        long count = 0;
        for (double height : heights) {
            if (Double.isFinite(height)) {
                sum += height * height;
                count++;
            }
        }
        return count == 0 ? 0 : sum / count;
    }
}
