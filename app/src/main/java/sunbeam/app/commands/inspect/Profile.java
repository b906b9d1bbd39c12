package sunbeam.app.commands.inspect;

import sunbeam.precompute.optics.HeightMap;

/**
 * Heights along a straight line through a patch's centre.
 *
 * @param positions along the line from its first point, metres
 * @param heights metres
 */
record Profile(double[] positions, double[] heights) {

    /**
     * Samples a line, at the finer pitch, as far as the patch reaches.
     *
     * @param direction radians counter-clockwise from +x
     * @param longest metres
     */
    static Profile through(HeightMap map, double direction, double longest) {
        double pitch = Math.min(map.pitchX(), map.pitchY());
        double cosine = Math.cos(direction);
        double sine = Math.sin(direction);
        int half = 0;
        while (half * pitch < 0.5 * longest && isInside(map, (half + 1) * pitch * cosine, (half + 1) * pitch * sine)) {
            half++;
        }
        double[] positions = new double[2 * half + 1];
        double[] heights = new double[positions.length];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = i * pitch;
            heights[i] = at(map, (i - half) * pitch * cosine, (i - half) * pitch * sine);
        }
        return new Profile(positions, heights);
    }

    /** Whether a point and its opposite, relative to the centre, lie on the samples. */
    private static boolean isInside(HeightMap map, double x, double y) {
        return Math.abs(x) <= 0.5 * (map.columns() - 1) * map.pitchX()
                && Math.abs(y) <= 0.5 * (map.rows() - 1) * map.pitchY();
    }

    /** Height of the sample that is nearest to a point, relative to the centre. */
    private static double at(HeightMap map, double x, double y) {
        return map.at((int) Math.floor(0.5 * map.columns() + x / map.pitchX() - 1e-9), (int)
                Math.floor(0.5 * map.rows() - y / map.pitchY() - 1e-9));
    }
}
