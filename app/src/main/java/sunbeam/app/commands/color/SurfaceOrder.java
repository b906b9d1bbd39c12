package sunbeam.app.commands.color;

import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.PrincipalDirection;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;

/**
 * What a surface's heights say of its colors: all that this command asks of {@code analysis}.
 *
 * @param plane in which the surface spreads most color: that of the strip along
 * @param found whether anything in the surface repeats
 * @param sentence what {@code inspect} says of it
 * @param grating the period that {@code inspect} tells; empty where the scan tells none
 */
record SurfaceOrder(PrincipalDirection plane, boolean found, String sentence, Optional<Grating> grating) {

    // Degrees to either side that hold every axis.
    private static final double ANY_DIRECTION = 90;

    /**
     * Lines at even distances.
     *
     * @param period metres
     * @param low of the interval that holds it with a probability of 95 %, metres
     * @param high of that interval, metres
     * @param azimuthDegrees across the lines, counter-clockwise from +x, at most 90 degrees from that of the plane
     */
    record Grating(double period, double low, double high, double azimuthDegrees) {
        /** Whether the interval is narrower than the period itself. */
        boolean isKnown() {
            return high - low < period;
        }

        /**
         * Where an order goes, by the grating equation for light from any side.
         *
         * @param distance of the lines, metres
         * @param order 1 or -1
         * @param wavelength metres
         * @return degrees to the normal, negative on the side away from the azimuth; NaN where there is no such order
         */
        double angleDegrees(double distance, int order, double wavelength, Direction light) {
            double axisX = Math.cos(Math.toRadians(azimuthDegrees));
            double axisY = Math.sin(Math.toRadians(azimuthDegrees));
            double across = order * wavelength / distance - (light.x() * axisX + light.y() * axisY);
            double beside = light.x() * axisY - light.y() * axisX;
            return Math.copySign(Math.toDegrees(Math.asin(Math.hypot(across, beside))), across);
        }
    }

    static SurfaceOrder of(Patch patch) {
        boolean periodic = patch.repetition() == Patch.Repetition.PERIODIC;
        PrincipalDirection plane =
                periodic ? PrincipalDirection.ofPeriod(patch.heights()) : PrincipalDirection.of(patch.heights());
        GratingPeriod period = GratingPeriod.of(patch);
        String sentence = sunbeam.precompute.analysis.Verdict.of(patch, period);
        if (patch.isMirror()) {
            return new SurfaceOrder(plane, false, sentence, Optional.empty());
        }
        Optional<Grating> grating = period.isTold()
                ? Optional.of(new Grating(period.period(), period.low(), period.high(), towards(plane, period)))
                : Optional.empty();
        return new SurfaceOrder(plane, period.hasOrder(), sentence, grating);
    }

    /** Of the two azimuths across the lines, degrees, the one on the plane's side. */
    private static double towards(PrincipalDirection plane, GratingPeriod period) {
        double azimuth = Math.toDegrees(period.azimuth());
        double turn = period.azimuth() - Math.toRadians(plane.azimuthDegrees());
        return Math.cos(turn) >= 0 ? azimuth : azimuth > 0 ? azimuth - 180 : azimuth + 180;
    }

    /** The plane's azimuth, and whether the surface knows it. */
    String describePlane() {
        double azimuth = plane.azimuthDegrees();
        return plane.halfWidthDegrees().orElse(0) < ANY_DIRECTION
                ? plane.describe() + ", in which the surface spreads most color"
                : String.format(Locale.ROOT, "%.0f degrees; no direction of the surface stands out", azimuth);
    }
}
