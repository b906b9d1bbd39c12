package sunbeam.precompute.evaluation;

import java.util.Arrays;
import java.util.List;
import sunbeam.precompute.optics.DirectionPair;

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

    /** Light and viewer of each angle. */
    public List<DirectionPair> pairs() {
        return Arrays.stream(angles).mapToObj(plane::pair).toList();
    }

    /** The largest step between two angles as one of u / lambda at the shortest wavelength, cycles per metre. */
    public double coarsestStep() {
        double coarsest = 0;
        for (int i = 1; i < angles.length; i++) {
            coarsest = Math.max(coarsest, Math.abs(plane.u(angles[i]) - plane.u(angles[i - 1])));
        }
        return coarsest / wavelengths[0];
    }
}
