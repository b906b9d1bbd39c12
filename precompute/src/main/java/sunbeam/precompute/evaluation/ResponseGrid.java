package sunbeam.precompute.evaluation;

/**
 * Where a response is evaluated.
 *
 * @param plane the light and the plane of the viewers
 * @param wavelengths metres, ascending
 * @param angles signed angles theta_r to the viewer, radians, ascending (see {@link GratingPlane})
 */
public record ResponseGrid(GratingPlane plane, double[] wavelengths, double[] angles) {
    public ResponseGrid {
        requireAscending("wavelengths", wavelengths);
        requireAscending("angles", angles);
        // 1e-9: the horizon itself, rounded, belongs to the hemisphere.
        double largest = plane.largestThetaR() + 1e-9;
        if (angles[0] < -largest || angles[angles.length - 1] > largest) {
            throw new IllegalArgumentException(
                    "angles leave the hemisphere: " + angles[0] + " to " + angles[angles.length - 1] + " rad");
        }
    }

    private static void requireAscending(String what, double[] values) {
        if (values.length == 0) {
            throw new IllegalArgumentException("no " + what);
        }
        for (int i = 1; i < values.length; i++) {
            if (!(values[i] > values[i - 1])) {
                throw new IllegalArgumentException(what + " do not ascend at " + i);
            }
        }
    }

    /** Smallest u of the grid's directions. */
    public double minimumU() {
        return plane.u(angles[angles.length - 1]);
    }

    /** Largest u of the grid's directions. */
    public double maximumU() {
        return plane.u(angles[0]);
    }

    /** Largest |w| of the grid's directions. */
    public double maximumW() {
        double largest = 0;
        for (double angle : angles) {
            largest = Math.max(largest, -plane.w(angle));
        }
        return largest;
    }
}
