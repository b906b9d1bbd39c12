package sunbeam.app.scene.mesh;

import org.joml.Vector3d;

/**
 * The scales as relief in the normals: rhombi in rows that are offset by half a scale, each tilted so that its rear edge
 * covers the front of the next. Positions along (rings) and around (columns) the body are counted in vertices; a scale is
 * four long and four wide, its edges run through vertices.
 */
final class SnakeScales {
    /** Vertices per scale, along and around. */
    static final int PITCH = 4;
    // Steepest slope is about twice this: scales glitter one by one, but the body's shading still reads.
    private static final double DEPTH = 0.28;
    private static final double TILT = 0.55;

    private SnakeScales() {}

    /**
     * A normal with the scales' relief.
     *
     * @param frame of the smooth skin
     * @param ring vertices from the snout
     * @param column vertices around
     * @param strength 0 for smooth skin, 1 for full relief
     */
    static Vector3d normal(SnakeSurface.Frame frame, double ring, double column, double strength) {
        double slopeAlong = height(ring + 0.5, column) - height(ring - 0.5, column);
        double slopeAround = height(ring, column + 0.5) - height(ring, column - 0.5);
        Vector3d bitangent = frame.normal().cross(frame.tangent(), new Vector3d());
        return new Vector3d(frame.normal())
                .fma(-strength * DEPTH * slopeAlong, frame.tangent())
                .fma(-strength * DEPTH * slopeAround, bitangent)
                .normalize();
    }

    /** Height in vertices over a scale: a dome, higher towards the tail. */
    static double height(double ring, double column) {
        double along = fromMiddle(ring);
        double around = fromMiddle(column);
        if (Math.abs(along) + Math.abs(around) > 1) {
            // The scale of the row between, half a pitch away in both directions.
            along = fromMiddle(ring + PITCH / 2.0);
            around = fromMiddle(column + PITCH / 2.0);
        }
        double edge = Math.abs(along) + Math.abs(around);
        return (1 - edge * edge) + TILT * along;
    }

    /** Distance from the nearest middle of a scale, -1 to 1. */
    private static double fromMiddle(double position) {
        double scales = position / PITCH;
        return 2 * (scales - Math.rint(scales));
    }
}
