package sunbeam.precompute.optics;

/** Unit vector in the tangent frame (x tangent, y bitangent, z normal) that points away from the surface. */
public record Direction(double x, double y, double z) {
    /** Returns the direction with an angle to the normal, 0..90, and an azimuth counter-clockwise from +x, in degrees. */
    public static Direction ofDegrees(double thetaDegrees, double phiDegrees) {
        double theta = Math.toRadians(thetaDegrees);
        double phi = Math.toRadians(phiDegrees);
        double sine = Math.sin(theta);
        return new Direction(sine * Math.cos(phi), sine * Math.sin(phi), Math.cos(theta));
    }

    public static Direction ofDisc(double x, double y) {
        return new Direction(x, y, Math.sqrt(Math.max(0, 1 - x * x - y * y)));
    }

    /** Returns this direction rotated about the normal, counter-clockwise seen from outside. */
    public Direction turned(double radians) {
        double cosine = Math.cos(radians);
        double sine = Math.sin(radians);
        return new Direction(cosine * x - sine * y, sine * x + cosine * y, z);
    }

    public double dot(Direction other) {
        return x * other.x + y * other.y + z * other.z;
    }
}
