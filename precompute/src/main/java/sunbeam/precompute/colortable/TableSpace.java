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

    /** Slices of w that a table of a design has. */
    int slices(TableDesign design);

    /** u and v themselves; w is apart. Beyond what two directions can have colors stay as they are at its edge. */
    record AllLights() implements TableSpace {
        /** Length of (u, v, w) that no two directions exceed. */
        public static final double REACH = 2;

        /**
         * Goes back to what two directions can have: what a pixel sees at a silhouette, taken as even, may reach beyond.
         *
         * @param uvw u, v, w and anything; changed
         */
        public static void within(double[] uvw) {
            double inside = REACH / Math.max(REACH, Math.sqrt(uvw[0] * uvw[0] + uvw[1] * uvw[1] + uvw[2] * uvw[2]));
            for (int axis = 0; axis < 3; axis++) {
                uvw[axis] *= inside;
            }
        }

        @Override
        public double[] place(double u, double v, double w) {
            return new double[] {u, v};
        }

        @Override
        public double[] uvw(double x, double y, double depth) {
            double square = x * x + y * y;
            double inside = square > REACH * REACH ? REACH / Math.sqrt(square) : 1;
            return new double[] {inside * x, inside * y, -depth};
        }

        @Override
        public int slices(TableDesign design) {
            return design.slices();
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
            double radius = Math.hypot(x, y);
            double distance = Math.min(radius, LARGEST);
            // With t = 1 - cos(theta / 2) the distance is the square root of t (2 - t)^3, and sin theta is 2 (1 - t) /
            // (2 - t) of it.
            double t = versedSine(distance * distance);
            double across = 2 * (1 - t) / (2 - t) * (radius > distance ? distance / radius : 1);
            // Light from below the horizon is no light; the table's rim goes on a little beyond it, to be smooth.
            double w = -Math.max(0, light.z() + 1 - 2 * t * (2 - t));
            return new double[] {-light.x() - across * x, -light.y() - across * y, w};
        }

        /** t of t (2 - t)^3, which is concave, so that Newton's steps from below never pass the root. */
        private static double versedSine(double product) {
            double t = product / 8;
            for (int i = 0; i < NEWTON_STEPS; i++) {
                double rest = 2 - t;
                t += (product - t * rest * rest * rest) / (rest * rest * (2 - 4 * t));
            }
            return t;
        }

        @Override
        public int slices(TableDesign design) {
            return 1;
        }
    }
}
