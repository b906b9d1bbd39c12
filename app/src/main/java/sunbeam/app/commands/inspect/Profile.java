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

    /** Height at a point relative to the centre, bilinear between samples. */
    private static double at(HeightMap map, double x, double y) {
        double column = 0.5 * (map.columns() - 1) + x / map.pitchX();
        double row = 0.5 * (map.rows() - 1) - y / map.pitchY();
        int left = clamp((int) Math.floor(column), map.columns());
        int top = clamp((int) Math.floor(row), map.rows());
        int right = clamp(left + 1, map.columns());
        int bottom = clamp(top + 1, map.rows());
        double across = column - left;
        double upper = map.at(left, top) * (1 - across) + map.at(right, top) * across;
        double lower = map.at(left, bottom) * (1 - across) + map.at(right, bottom) * across;
        return upper + (row - top) * (lower - upper);
    }

    private static int clamp(int index, int count) {
        return Math.max(0, Math.min(count - 1, index));
    }
}
