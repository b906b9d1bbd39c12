package sunbeam.precompute.analysis;

import sunbeam.precompute.optics.HeightMap;

/**
 * The frequency of a wave of the heights; its opposite is the same wave.
 *
 * @param x cycles per metre along +x
 * @param y cycles per metre along +y, upwards
 */
public record SpatialFrequency(double x, double y) {

    /** Cycles per metre. */
    public double length() {
        return Math.hypot(x, y);
    }

    /** Metres. */
    public double period() {
        return 1 / length();
    }

    /** Direction across the lines, radians counter-clockwise from +x, above -pi/2 to pi/2. */
    public double azimuth() {
        double angle = Math.atan2(y, x);
        return angle > Math.PI / 2 ? angle - Math.PI : angle <= -Math.PI / 2 ? angle + Math.PI : angle;
    }

    /** Turned counter-clockwise, radians. */
    SpatialFrequency turned(double angle) {
        double cosine = Math.cos(angle);
        double sine = Math.sin(angle);
        return new SpatialFrequency(cosine * x - sine * y, sine * x + cosine * y);
    }

    /** The sine of the angle to another wave, 0..1. */
    double sineTo(SpatialFrequency other) {
        return Math.abs(x * other.y - y * other.x) / (length() * other.length());
    }

    /** To another wave or its opposite, cycles per metre. */
    double distance(SpatialFrequency other) {
        return Math.min(Math.hypot(x - other.x, y - other.y), Math.hypot(x + other.x, y + other.y));
    }

    SpatialFrequency times(double factor) {
        return new SpatialFrequency(factor * x, factor * y);
    }

    /** Turned and stretched: so much more along the wave and along its lines, cycles per metre. */
    SpatialFrequency corrected(double along, double across) {
        double cosine = x / length();
        double sine = y / length();
        return new SpatialFrequency(x + along * cosine - across * sine, y + along * sine + across * cosine);
    }

    /** How many periods fit, along the wave, into the ellipse that touches a scan's sides. */
    double periodsIn(HeightMap scan) {
        return length() * length() / Math.hypot(x / scan.width(), y / scan.height());
    }

    /** Samples a period along the axis that has fewer; infinite along a single row or column. */
    double samplesIn(HeightMap scan) {
        double alongX = scan.columns() > 1 ? Math.abs(x) * scan.pitchX() : 0;
        double alongY = scan.rows() > 1 ? Math.abs(y) * scan.pitchY() : 0;
        return 1 / Math.max(alongX, alongY);
    }
}
