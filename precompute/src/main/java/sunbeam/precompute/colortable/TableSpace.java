package sunbeam.precompute.colortable;

import sunbeam.precompute.optics.Direction;

/** Coordinates (x, y) in which colors vary no faster than in u and v, so that the steps of a {@link TableDesign} suffice. */
public sealed interface TableSpace {
    double[] place(double u, double v, double w);

    /** Returns u, v, w at coordinates, in the slice of this |w| if the space has slices. */
    double[] uvw(double x, double y, double depth);

    /** Space of a table of all lights: x is u, y is v, and w has slices. Points beyond {@link #REACH} have the color there. */
    record AllLights() implements TableSpace {
        /** Largest |(u, v, w)| of two directions. */
        public static final double REACH = 2;

        /** Shortens the first three values, u, v, w, to {@link #REACH}, which footprints extrapolated at silhouettes may exceed. */
        public static void shorten(double[] uvw) {
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
    }

    /**
     * Space of a table of one light: w follows from u and v, so that one slice suffices. Its slope is infinite at the horizon; so the view
     * at the angle theta to the normal has the radius (sin theta + 2 sin(theta / 2)) / 2, which is smooth there.
     */
    record OneLight(Direction light) implements TableSpace {
        static final double HORIZON = radius(Math.PI / 2);
        // Below the horizon; up to here u and v vary no faster than x and y.
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

        @Override
        public double[] uvw(double x, double y, double depth) {
            double radius = Math.hypot(x, y);
            double distance = Math.min(radius, LARGEST);
            // With t = 1 - cos(theta / 2) the squared radius is t (2 - t)^3, and sin theta 2 (1 - t) / (2 - t) radii.
            double t = versedSine(distance * distance);
            double across = 2 * (1 - t) / (2 - t) * (radius > distance ? distance / radius : 1);
            // Below the horizon, where there are no views, the grid continues, so that filters see a smooth function.
            double w = -Math.max(0, light.z() + 1 - 2 * t * (2 - t));
            return new double[] {-light.x() - across * x, -light.y() - across * y, w};
        }

        /** Solves t (2 - t)^3 = product, which is concave, so that Newton's steps from below never pass the root. */
        private static double versedSine(double product) {
            double t = product / 8;
            for (int i = 0; i < NEWTON_STEPS; i++) {
                double rest = 2 - t;
                t += (product - t * rest * rest * rest) / (rest * rest * (2 - 4 * t));
            }
            return t;
        }
    }
}
