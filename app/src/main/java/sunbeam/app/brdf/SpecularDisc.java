package sunbeam.app.brdf;

import sunbeam.app.picture.AutoExposure;
import sunbeam.precompute.optics.Direction;

/**
 * The pixels of a map in which the mirror's image of the light lies.
 *
 * @param size width and height of the map in pixels
 * @param light towards the light
 * @param radius of the disc, in sines of the angle to the normal
 */
public record SpecularDisc(int size, Direction light, double radius) implements AutoExposure.Specular {
    @Override
    public boolean contains(int pixel) {
        double x = (2.0 * (pixel % size) + 1) / size - 1;
        int row = pixel / size;
        double y = 1 - (2.0 * row + 1) / size;
        return Math.hypot(x + light.x(), y + light.y()) < radius;
    }
}
