package sunbeam.app.scene.texture;

import java.nio.file.Files;
import java.nio.file.Path;
import sunbeam.app.files.input.InputException;

/**
 * Flow map: direction of the nanostructure's x axis at each place of a mesh's texture. Red is the direction's component along the tangent
 * (right in the picture), green along the bitangent (up); the bytes 1, 128 and 255 mean -1, 0 and 1. Blue and alpha are ignored. Shaders
 * interpolate the vectors, not doubled angles as for undirected lines, because a height map turned by 180 degrees is another surface.
 */
public final class OrientationMap {
    /** Name of the mesh's own tangents instead of a map. */
    public static final String NONE = "none";

    private static final int ZERO = 128;
    // Least length of a vector, a sixteenth of the longest, in steps of a byte; eight bits resolve the direction of a
    // shorter one too coarsely.
    private static final int SHORTEST = 8;

    private OrientationMap() {}

    static BodyTexture load(String nameOrFile) {
        if (nameOrFile.equals(NONE)) {
            return new BodyTexture(1, 1, new byte[] {-1, (byte) ZERO, (byte) ZERO, -1});
        }
        Path file = Path.of(nameOrFile);
        if (!Files.exists(file)) {
            throw new InputException("there is no orientation map " + file + "; name an image file, or " + NONE);
        }
        BodyTexture map = ImageTextureReader.read(file);
        requireDirections(file, map);
        return map;
    }

    private static void requireDirections(Path file, BodyTexture map) {
        boolean gray = true;
        for (int texel = 0; texel < map.width() * map.height(); texel++) {
            int red = map.rgba()[4 * texel] & 0xff;
            int green = map.rgba()[4 * texel + 1] & 0xff;
            if (Math.hypot(red - ZERO, green - ZERO) < SHORTEST) {
                throw new InputException("orientation map " + file + " has no direction in column "
                        + texel % map.width() + ", row " + texel / map.width() + ": red " + red + " and green " + green
                        + " are nearly " + ZERO + ", which is zero; paint one, (255, 128) for the mesh's own tangent");
            }
            gray &= red == green && green == (map.rgba()[4 * texel + 2] & 0xff);
        }
        if (gray) {
            throw new InputException("orientation map " + file
                    + " is gray; its red and green must be x and y of a direction, as in a flow map");
        }
    }
}
