package sunbeam.precompute.optics;

/**
 * Pair of directions: {@code wi} towards the light, {@code wr} towards the viewer. The diffraction integral depends on (u, v, w) = -(wi +
 * wr), so w is at most 0 (Stam 1999, section 4).
 */
public record DirectionPair(Direction wi, Direction wr) {
    public double u() {
        return -(wi.x() + wr.x());
    }

    public double v() {
        return -(wi.y() + wr.y());
    }

    public double w() {
        return -(wi.z() + wr.z());
    }

    public double cosThetaI() {
        return wi.z();
    }

    public double cosThetaR() {
        return wr.z();
    }

    /** Returns both directions rotated about the normal, counter-clockwise seen from outside. */
    public DirectionPair turned(double radians) {
        return new DirectionPair(wi.turned(radians), wr.turned(radians));
    }

    /** Returns the cosine of the angle between the half vector and either direction. */
    public double cosThetaD() {
        return Math.sqrt(Math.max(0, 0.5 * (1 + wi.dot(wr))));
    }
}
