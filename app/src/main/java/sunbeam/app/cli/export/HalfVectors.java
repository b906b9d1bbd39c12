package sunbeam.app.cli.export;

import java.util.Arrays;

/**
 * The map from the unit square to half vectors for one direction, as tensor files have it: by a density over azimuth and
 * angle of the half vector. Here it is such that a place of the square has the same (u, v), whatever the direction: (u, v)
 * has the half vector's azimuth, and its length r grows with the half vector's angle, dr = 2 cos(angle of the other
 * direction), until that is at the horizon. So orders stay where they are between the directions of a file.
 *
 * @param azimuths share of the square's rows by azimuth of the half vector, from -180 to 180 degrees
 * @param density by row and column, {@code [row * columns + column]}; the mean is 1
 */
record HalfVectors(LinearDensity azimuths, float[] density, int columns) {
    // Share of the square's columns for long (u, v), which fewer directions see than short ones.
    private static final double FEWER_OUTSIDE = 0.35;
    private static final double FARTHEST = 2;

    static HalfVectors of(LinearDensity azimuths, double phi, double theta, int columns) {
        int rows = azimuths.values().length;
        float[] density = new float[rows * columns];
        for (int row = 0; row < rows; row++) {
            double[] values = row(Math.cos(phi - azimuth(row, rows)), theta, columns);
            double scale = azimuths.values()[row]
                    * (rows - 1)
                    / azimuths.total()
                    * (columns - 1)
                    / LinearDensity.of(values).total();
            for (int column = 0; column < columns; column++) {
                density[row * columns + column] = (float) (scale * values[column]);
            }
        }
        return new HalfVectors(azimuths, density, columns);
    }

    static double azimuth(double row, int rows) {
        return -Math.PI + 2 * Math.PI * row / (rows - 1);
    }

    static double angle(double column, int columns) {
        double share = column / (columns - 1);
        return 0.5 * Math.PI * share * share;
    }

    /** Share of the columns that lie within a length of (u, v). */
    private static double share(double length) {
        return length * (1 - 0.5 * FEWER_OUTSIDE * length) / (FARTHEST * (1 - 0.5 * FEWER_OUTSIDE * FARTHEST));
    }

    /** @param cosine of the azimuth between direction and half vector */
    private static double[] row(double cosine, double theta, int columns) {
        double along = Math.sin(theta) * cosine;
        double up = Math.cos(theta);
        double horizon = 0.5 * Math.atan2(up, -along);
        double[] values = new double[columns];
        int hidden = 0;
        for (int column = 0; column < columns && angle(column, columns) < horizon; column++) {
            double twice = 2 * angle(column, columns);
            double length = along * (1 - Math.cos(twice)) + up * Math.sin(twice);
            double cosOther = along * Math.sin(twice) + up * Math.cos(twice);
            values[column] = (1 - FEWER_OUTSIDE * length) * cosOther * column;
            hidden = column + 1;
        }
        double longest = along * (1 - Math.cos(2 * horizon)) + up * Math.sin(2 * horizon);
        double seen = share(longest);
        double sum = LinearDensity.of(values).total();
        for (int column = 0; column < hidden; column++) {
            values[column] *= seen / sum;
        }
        // The hidden columns take the rest, so that the share of the visible ones stays.
        if (hidden + 1 < columns) {
            Arrays.fill(values, hidden + 1, columns, (1 - seen) / (columns - hidden - 1.5));
        }
        return values;
    }

    /** Interpolates between two rows, from their densities alone. */
    static LinearDensity row(float[] density, int columns, double row) {
        int below = Math.max(0, Math.min(density.length / columns - 2, (int) row));
        double beyond = row - below;
        double[] values = new double[columns];
        for (int column = 0; column < columns; column++) {
            values[column] =
                    (1 - beyond) * density[below * columns + column] + beyond * density[(below + 1) * columns + column];
        }
        return LinearDensity.of(values);
    }
}
