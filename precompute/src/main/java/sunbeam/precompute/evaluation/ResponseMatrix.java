package sunbeam.precompute.evaluation;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.MathArrays;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;

/** A surface's response {@code [wavelength][angle]}: diffracted power, 1 for a flat mirror in specular direction, or relative radiance. */
public record ResponseMatrix(ResponseGrid grid, double[][] values) {
    /** Converts power to the relative radiance rho that BRDF maps show (see {@link Gain#relativeRadiance}). */
    public ResponseMatrix toRelativeRadiance() {
        double[] gains = Arrays.stream(grid.angles())
                .map(angle -> Gain.relativeRadiance(grid.plane().pair(angle)))
                .toArray();
        double[][] radiance = Arrays.stream(values)
                .map(row -> MathArrays.ebeMultiply(gains, row))
                .toArray(double[][]::new);
        return new ResponseMatrix(grid, radiance);
    }

    /** Linear between angles; NaN beyond the grid. The frequency is u / lambda in cycles per meter. */
    double atFrequency(int row, double frequency) {
        double[] angles = grid.angles();
        double angle = grid.plane().thetaR(frequency * grid.wavelengths()[row]);
        if (!(angle >= angles[0] && angle <= angles[angles.length - 1])) {
            return Double.NaN;
        }
        int found = Arrays.binarySearch(angles, angle);
        if (found >= 0) {
            return values[row][found];
        }
        int next = -found - 1;
        double fraction = (angle - angles[next - 1]) / (angles[next] - angles[next - 1]);
        return values[row][next - 1] + fraction * (values[row][next] - values[row][next - 1]);
    }

    /** Wavelengths, meters, and signed angles theta_r, radians, of a response, both ascending (see {@link GratingPlane}). */
    public record ResponseGrid(GratingPlane plane, double[] wavelengths, double[] angles) {
        public List<DirectionPair> pairs() {
            return Arrays.stream(angles).mapToObj(plane::pair).toList();
        }

        /** Returns the largest step of u / lambda between neighboring angles, at the shortest wavelength, in cycles per meter. */
        public double coarsestStep() {
            DoubleStream steps = IntStream.range(1, angles.length)
                    .mapToDouble(i -> Math.abs(plane.u(angles[i]) - plane.u(angles[i - 1])));
            return steps.max().orElse(0) / wavelengths[0];
        }
    }
}
