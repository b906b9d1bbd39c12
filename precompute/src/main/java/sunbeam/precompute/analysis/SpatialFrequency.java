package sunbeam.precompute.analysis;

import sunbeam.precompute.optics.HeightMap;

/** Spatial frequency of a wave in cycles per meter along +x and +y (upwards); (-x, -y) is the same wave. */
public record SpatialFrequency(double x, double y) {
    private static final double ALIKE = 0.05;

    public double length() {
        return Math.sqrt(x * x + y * y); // a third of the time of Math.hypot
    }

    public double period() {
        return 1 / length();
    }

    /** Returns radians counter-clockwise from +x, above -pi/2 and at most pi/2. */
    public double azimuth() {
        double angle = Math.atan2(y, x);
        return angle > Math.PI / 2 ? angle - Math.PI : angle <= -Math.PI / 2 ? angle + Math.PI : angle;
    }

    SpatialFrequency turned(double angle) {
        double cosine = Math.cos(angle);
        double sine = Math.sin(angle);
        return new SpatialFrequency(cosine * x - sine * y, sine * x + cosine * y);
    }

    double sineTo(SpatialFrequency other) {
        return Math.abs(x * other.y - y * other.x) / (length() * other.length());
    }

    /** Returns the distance to the wave or its opposite, whichever is nearer, cycles per meter. */
    double distance(SpatialFrequency other) {
        return Math.min(Math.hypot(x - other.x, y - other.y), Math.hypot(x + other.x, y + other.y));
    }

    /** Whether lengths differ by less than 5 %; a scanner's axes differ in scale, too. */
    boolean isAsLongAs(SpatialFrequency other) {
        return Math.abs(other.length() / length() - 1) < ALIKE;
    }

    SpatialFrequency plus(SpatialFrequency other) {
        return new SpatialFrequency(x + other.x, y + other.y);
    }

    SpatialFrequency times(double factor) {
        return new SpatialFrequency(factor * x, factor * y);
    }

    /** Adds corrections, cycles per meter, along the wave and, counter-clockwise from it, along its lines. */
    SpatialFrequency corrected(double along, double across) {
        double cosine = x / length();
        double sine = y / length();
        return new SpatialFrequency(x + along * cosine - across * sine, y + along * sine + across * cosine);
    }

    /** Periods along the wave in the ellipse inscribed in a scan. */
    double periodsIn(HeightMap scan) {
        return length() * length() / Math.hypot(x / scan.width(), y / scan.height());
    }

    /** Samples per period along the axis that has fewer; one of a single sample does not count. */
    double samplesIn(HeightMap scan) {
        double alongX = scan.columns() > 1 ? Math.abs(x) * scan.pitchX() : 0;
        double alongY = scan.rows() > 1 ? Math.abs(y) * scan.pitchY() : 0;
        return 1 / Math.max(alongX, alongY);
    }
}
