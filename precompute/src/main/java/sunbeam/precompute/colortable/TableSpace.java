package sunbeam.precompute.colortable;

import sunbeam.precompute.optics.Direction;

/**
 * The two coordinates (x, y) over which a table lies: nowhere do u and v change faster than they do. What is one here is one
 * there, so that steps of both are the same.
 */
public sealed interface TableSpace {

    /**
     * Where (u, v, w) lies.
     *
     * @return x, y
     */
    double[] place(double u, double v, double w);

    /**
     * What lies at a place of a slice.
     *
     * @param depth |w| of the slice, where the space has slices
     * @return u, v, w
     */
    double[] uvw(double x, double y, double depth);

    /** u and v themselves; w is apart. */
    record Free() implements TableSpace {
        @Override
        public double[] place(double u, double v, double w) {
            return new double[] {u, v};
        }

        @Override
        public double[] uvw(double x, double y, double depth) {
            return new double[] {x, y, -depth};
        }
    }

    /**
     * What one light shows: w follows from u and v, so that one slice has it all. As a function of u and v it ends at the
     * horizon with an infinite slope; so the view at the angle theta to the normal lies at (sin theta + 2 sin(theta / 2)) / 2
     * from the middle, which is smooth across the horizon.
     *
     * @param light towards the light
     */
    record OneLight(Direction light) implements TableSpace {
        /** Distance of the horizon from the middle. */
        static final double HORIZON = radius(Math.PI / 2);

        // So far beyond the horizon u and v change no faster than their places.
        private static final double LARGEST = radius(Math.toRadians(101));
        private static final int NEWTON_STEPS = 8;

        private static double radius(double theta) {
            return 0.5 * Math.sin(theta) + Math.sin(theta / 2);
        }

        @Override
        public double[] place(double u, double v, double w) {
            double viewZ = -w - light.z();
            double scale = 0.5 + Math.sqrt(0.5 / (1 + viewZ));
            return new double[] {scale * (-u - light.x()), scale * (-v - light.y())};
        }

        /** Beyond the largest distance the colors stay as they are there. */
        @Override
        public double[] uvw(double x, double y, double depth) {
            double distance = Math.min(Math.hypot(x, y), LARGEST);
            double theta = angle(distance);
            double across = distance == 0 ? 1 : Math.sin(theta) / Math.hypot(x, y);
            // Light from below the horizon is no light; the table's rim goes on a little beyond it, to be smooth.
            double w = -Math.max(0, light.z() + Math.cos(theta));
            return new double[] {-light.x() - across * x, -light.y() - across * y, w};
        }

        /** The inverse of {@link #radius}. It is concave, so that Newton's steps from below never pass the root. */
        private static double angle(double distance) {
            double theta = distance;
            for (int i = 0; i < NEWTON_STEPS; i++) {
                theta += (distance - radius(theta)) / (0.5 * (Math.cos(theta) + Math.cos(theta / 2)));
            }
            return theta;
        }
    }
}
