package sunbeam.precompute.evaluation;

import java.util.Arrays;
import java.util.List;
import sunbeam.precompute.optics.DirectionPair;

/**
 * Wavelengths and directions at which a response is evaluated.
 *
 * @param wavelengths meters, ascending
 * @param angles signed angles theta_r to the viewer, radians, ascending (see {@link GratingPlane})
 */
public record ResponseGrid(GratingPlane plane, double[] wavelengths, double[] angles) {
    public List<DirectionPair> pairs() {
        return Arrays.stream(angles).mapToObj(plane::pair).toList();
    }

    /** Returns the largest step of u / lambda between neighboring angles, at the shortest wavelength, in cycles per meter. */
    public double coarsestStep() {
        double coarsest = 0;
        for (int i = 1; i < angles.length; i++) {
            coarsest = Math.max(coarsest, Math.abs(plane.u(angles[i]) - plane.u(angles[i - 1])));
        }
        return coarsest / wavelengths[0];
    }
}
