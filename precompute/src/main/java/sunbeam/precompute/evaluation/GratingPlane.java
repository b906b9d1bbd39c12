package sunbeam.precompute.evaluation;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;

/**
 * Set of directions into which a grating diffracts one light: those whose (u, v) lies along the grating's direction. If the light is not in
 * the plane of that direction, it is the cone on which the component across the grating is the mirror's (conical diffraction).
 *
 * <p>A direction to the viewer has a signed angle theta_r, whose sine is its component along the grating's direction, positive on the
 * light's side for phi 0: the mirror lies at theta_r = -theta_i. The grating equation then reads
 * {@code -u = sin theta_i cos phi + sin theta_r = m lambda / d}.
 *
 * @param thetaI angle of the light to the normal, radians, 0 to below pi / 2
 * @param phiI azimuth of the light against the grating's direction, radians
 * @param azimuth the grating's direction in the patch, radians counter-clockwise from +x
 */
public record GratingPlane(double thetaI, double phiI, double azimuth) {
    public double lightAlong() {
        return Math.sin(thetaI) * Math.cos(phiI);
    }

    /** The viewer's component is its opposite. */
    private double lightAcross() {
        return Math.sin(thetaI) * Math.sin(phiI);
    }

    /** Returns the component of (u, v) along the grating's direction; the component across it is zero. */
    public double u(double thetaR) {
        return -(lightAlong() + Math.sin(thetaR));
    }

    /** Returns the signed angle to the viewer for a u, radians; NaN if no direction has this u. */
    public double thetaR(double u) {
        double sine = -u - lightAlong();
        return Math.abs(sine) <= 1 ? Math.asin(sine) : Double.NaN;
    }

    /** Returns the largest |theta_r| of a direction above the surface, radians. */
    public double largestThetaR() {
        return Math.acos(Math.min(1, Math.abs(lightAcross())));
    }

    public DirectionPair pair(double thetaR) {
        Direction wi = new Direction(lightAlong(), lightAcross(), Math.cos(thetaI));
        Direction wr = new Direction(Math.sin(thetaR), -lightAcross(), cosine(thetaR));
        return new DirectionPair(wi, wr).turned(azimuth);
    }

    private double cosine(double thetaR) {
        if (lightAcross() == 0) {
            return Math.cos(thetaR);
        }
        double sine = Math.sin(thetaR);
        return Math.sqrt(Math.max(0, 1 - sine * sine - lightAcross() * lightAcross()));
    }

    /** Range of periods, in meters, in which a grating's first order is searched. */
    public record FirstOrder(double shortest, double longest) {
        public static FirstOrder around(double period, double factor) {
            return new FirstOrder(period / factor, period * factor);
        }

        /** Returns the geometric mean, meters. */
        public double middle() {
            return Math.sqrt(shortest * longest);
        }

        /** Returns evenly spaced theta_r, radians, over all directions that see the order +1 or -1 between two wavelengths, meters. */
        public Optional<double[]> angles(
                GratingPlane plane, double shortestWavelength, double longestWavelength, int count) {
            double horizon = Math.sin(plane.largestThetaR());
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int sign = -1; sign <= 1; sign += 2) {
                double near = -plane.lightAlong() - sign * shortestWavelength / longest;
                double far = -plane.lightAlong() - sign * longestWavelength / shortest;
                double left = Math.max(-horizon, Math.min(near, far));
                double right = Math.min(horizon, Math.max(near, far));
                low = left < right ? Math.min(low, left) : low;
                high = left < right ? Math.max(high, right) : high;
            }
            if (!(low < high)) {
                return Optional.empty();
            }
            double first = Math.asin(low);
            double range = Math.asin(high) - first;
            return Optional.of(IntStream.range(0, count)
                    .mapToDouble(i -> first + range * i / (count - 1))
                    .toArray());
        }
    }

    /** A surface's response {@code [wavelength][angle]}: diffracted power, 1 for a flat mirror in specular direction, or relative radiance. */
    public record ResponseMatrix(ResponseGrid grid, double[][] values) {
        /** Converts power to the relative radiance rho that BRDF maps show. */
        public ResponseMatrix toRelativeRadiance(Gain gain) {
            List<DirectionPair> pairs = grid.pairs();
            double[][] radiance = new double[values.length][pairs.size()];
            for (int row = 0; row < radiance.length; row++) {
                for (int i = 0; i < radiance[row].length; i++) {
                    radiance[row][i] = gain.relativeRadiance(pairs.get(i), grid.wavelengths()[row]) * values[row][i];
                }
            }
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
}
