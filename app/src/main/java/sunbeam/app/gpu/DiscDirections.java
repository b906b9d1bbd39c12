package sunbeam.app.gpu;

import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/**
 * Directions at the centers of a BRDF map's pixels (shaders/brdf_map.frag).
 *
 * @param size width and height of the map in pixels
 * @param light towards the light
 */
public record DiscDirections(int size, Direction light) {

    /**
     * Returns the direction of one pixel.
     *
     * @param pixel counted row by row from the top left; must lie inside the disc
     */
    public DirectionPair at(int pixel) {
        return new DirectionPair(light, Direction.ofDisc(x(pixel), y(pixel)));
    }

    public boolean covers(int pixel) {
        return x(pixel) * x(pixel) + y(pixel) * y(pixel) < 1;
    }

    private double x(int pixel) {
        return (2.0 * (pixel % size) + 1) / size - 1;
    }

    private double y(int pixel) {
        int row = pixel / size;
        return 1 - (2.0 * row + 1) / size;
    }
}
