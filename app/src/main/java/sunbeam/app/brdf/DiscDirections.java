package sunbeam.app.brdf;

import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.Geometry;

/**
 * The directions that the pixels of a BRDF map show, at their centres, as shaders/brdf_map.frag has them.
 *
 * @param size width and height of the map in pixels
 * @param light towards the light
 */
record DiscDirections(int size, Direction light) {

    /** @param pixel counted row by row from the top left; must lie inside the disc */
    Geometry at(int pixel) {
        return new Geometry(light, Direction.ofDisc(x(pixel), y(pixel)));
    }

    /** Whether a pixel shows a direction within a radius of the specular one, measured on the disc. */
    boolean nearSpecular(int pixel, double radius) {
        return Math.hypot(x(pixel) + light.x(), y(pixel) + light.y()) < radius;
    }

    private double x(int pixel) {
        return (2.0 * (pixel % size) + 1) / size - 1;
    }

    private double y(int pixel) {
        int row = pixel / size;
        return 1 - (2.0 * row + 1) / size;
    }
}
