package sunbeam.app.cli.export;

import java.util.Arrays;

/**
 * Map from the unit square to half vectors for one first direction. A tensor file stores it as a density over azimuth and angle of the half
 * vector. It is chosen so that a point of the square means the same (u, v) for every first direction; so orders stay in place when a reader
 * interpolates between these. The vector -(u, v) has the half vector's azimuth. Its length r grows with the half vector's angle a, dr/da =
 * 2 cos(angle of the second direction), until the second direction is at the horizon.
 *
 * @param azimuths density of the square's rows over the half vector's azimuth, from -180 to 180 degrees
 * @param density density at each azimuth (row) and angle (column), {@code [row * columns + column]}; its integral is 1
 */
record HalfVectors(Density azimuths, float[] density, int columns) {
    // Decrease of the density with |(u, v)|: fewer pairs of directions reach long (u, v) than short ones.
    private static final double FEWER_OUTSIDE = 0.35;

    /** A density, linear between nodes at distance 1, not negative, not all 0, with its integral up to each node. */
    record Density(double[] sums, double[] values) {
        static Density of(double[] values) {
            double[] sums = new double[values.length];
            for (int i = 1; i < values.length; i++) {
                sums[i] = sums[i - 1] + 0.5 * (values[i - 1] + values[i]);
            }
            return new Density(sums, values);
        }

        double total() {
            return sums[sums.length - 1];
        }

        double at(double place) {
            int below = below(place);
            return values[below] + (place - below) * (values[below + 1] - values[below]);
        }

        /** Returns the integral up to a fractional node index, relative to the whole integral. */
        double share(double place) {
            int below = below(place);
            double beyond = place - below;
            double slope = values[below + 1] - values[below];
            return (sums[below] + beyond * (values[below] + 0.5 * beyond * slope)) / total();
        }

        /** Returns the fractional node index up to which the integral is this share of the whole. */
        double place(double share) {
            double wanted = share * total();
            int below = 0;
            while (below < sums.length - 2 && sums[below + 1] < wanted) {
                below++;
            }
            double rest = Math.max(0, wanted - sums[below]);
            double slope = values[below + 1] - values[below];
            // The root of rest = value x + slope x^2 / 2, in a form that is stable for every slope.
            double root = Math.sqrt(Math.max(0, values[below] * values[below] + 2 * slope * rest));
            double sum = values[below] + root;
            return below + (sum > 0 ? Math.min(1, 2 * rest / sum) : 0);
        }

        private int below(double place) {
            return Math.max(0, Math.min(values.length - 2, (int) place));
        }
    }

    static HalfVectors of(Density azimuths, double phi, double theta, int columns) {
        int rows = azimuths.values().length;
        float[] density = new float[rows * columns];
        for (int row = 0; row < rows; row++) {
            double[] values = row(Math.cos(phi - azimuth(row, rows)), theta, columns);
            double total = Density.of(values).total();
            double scale = azimuths.values()[row] * (rows - 1) / azimuths.total() * (columns - 1) / total;
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

    /** Returns the share of the square's columns for (u, v) that are not longer than {@code length}. */
    private static double share(double length) {
        double whole = GridShape.REACH * (1 - 0.5 * FEWER_OUTSIDE * GridShape.REACH);
        return length * (1 - 0.5 * FEWER_OUTSIDE * length) / whole;
    }

    /** @param cosine cosine of the azimuth from the first direction to the half vector */
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
        double seen = share(along * (1 - Math.cos(2 * horizon)) + up * Math.sin(2 * horizon));
        double scale = seen / Density.of(values).total();
        Arrays.setAll(values, column -> scale * values[column]);
        // The columns whose second direction is below the horizon take the rest, so that the others keep their share.
        if (hidden + 1 < columns) {
            Arrays.fill(values, hidden + 1, columns, (1 - seen) / (columns - hidden - 1.5));
        }
        return values;
    }

    static Density row(float[] density, int columns, double row) {
        int below = Math.max(0, Math.min(density.length / columns - 2, (int) row));
        double beyond = row - below;
        double[] values = new double[columns];
        for (int column = 0; column < columns; column++) {
            values[column] =
                    (1 - beyond) * density[below * columns + column] + beyond * density[(below + 1) * columns + column];
        }
        return Density.of(values);
    }
}
