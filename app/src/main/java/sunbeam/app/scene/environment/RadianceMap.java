package sunbeam.app.scene.environment;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.precompute.files.Checksum;
import sunbeam.precompute.files.InputException;

/**
 * Radiance from all directions, linear Rec. 709, in equal steps of azimuth and elevation. Row 0 is at the zenith (+z). The middle column is
 * at +y, further right is clockwise seen from above: as the map looks from its middle.
 */
public final class RadianceMap {
    /** Larger files are averaged. */
    static final int MOST_WIDTH = 1024;

    private final int height;
    private final float[] rgb;
    private LightTree tree;

    /** @param rgb {@code height * (2 * height) * 3} values from 0 on; not copied */
    RadianceMap(int height, float[] rgb) {
        this.height = height;
        this.rgb = rgb;
    }

    /** Returns a built-in map or reads a file; throws InputException if there is none, or the file cannot be used. */
    public static RadianceMap load(String nameOrFile) {
        if (BuiltInEnvironments.NAMES.contains(nameOrFile)) {
            return BuiltInEnvironments.of(nameOrFile);
        }
        InputException.refuseIf(
                nameOrFile.toLowerCase(Locale.ROOT).endsWith(".exr"),
                "environment " + nameOrFile + " is OpenEXR, which is not read here; convert it to .hdr (Radiance)");
        return RadianceFile.read(Path.of(nameOrFile));
    }

    /** The surroundings of scenes with key {@code sky}. */
    public static RadianceMap sky() {
        return BuiltInEnvironments.Shared.SKY;
    }

    public static List<String> builtIn() {
        return BuiltInEnvironments.NAMES;
    }

    public String digest() {
        return new Checksum().add(rgb).hex();
    }

    int height() {
        return height;
    }

    int width() {
        return 2 * height;
    }

    float value(int row, int column, int channel) {
        return rgb[3 * (row * width() + column) + channel];
    }

    static double luminance(double red, double green, double blue) {
        return 0.2126729 * red + 0.7151522 * green + 0.0721750 * blue;
    }

    double luminance(int row, int column) {
        return luminance(value(row, column, 0), value(row, column, 1), value(row, column, 2));
    }

    double elevation(double row) {
        return Math.PI * (0.5 - (row + 0.5) / height);
    }

    double azimuth(double column) {
        return 2 * Math.PI * (0.75 - (column + 0.5) / width());
    }

    /** Solid angle of a pixel. */
    double solidAngle(int row) {
        return Math.PI / height * (Math.sin(elevation(row - 0.5)) - Math.sin(elevation(row + 0.5)));
    }

    static Vector3d direction(double azimuth, double elevation) {
        double across = Math.cos(elevation);
        return new Vector3d(across * Math.cos(azimuth), across * Math.sin(azimuth), Math.sin(elevation));
    }

    /** Integral of luminance over all directions. */
    double luminance() {
        double sum = 0;
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width(); column++) {
                sum += solidAngle(row) * luminance(row, column);
            }
        }
        return sum;
    }

    /** Returns the linear Rec. 709 in a direction of any length above 0, interpolated. */
    public Vector3f radiance(Vector3fc direction) {
        double column = (0.75 - Math.atan2(direction.y(), direction.x()) / (2 * Math.PI)) * width() - 0.5;
        double sine = Math.max(-1, Math.min(1, direction.z() / direction.length()));
        double row = (0.5 - Math.asin(sine) / Math.PI) * height - 0.5;
        int left = (int) Math.floor(column);
        int top = (int) Math.floor(row);
        Vector3f sum = new Vector3f();
        for (int corner = 0; corner < 4; corner++) {
            int x = left + corner % 2;
            int y = top + corner / 2;
            float weight = (float) ((1 - Math.abs(column - x)) * (1 - Math.abs(row - y)));
            int inside = Math.max(0, Math.min(height - 1, y));
            int around = Math.floorMod(x, width());
            sum.add(
                    weight * value(inside, around, 0),
                    weight * value(inside, around, 1),
                    weight * value(inside, around, 2));
        }
        return sum;
    }

    /** Mean linear Rec. 709 close above the horizon. */
    public Vector3f horizon() {
        int row = (int) (height * (0.5 - 3.0 / 180));
        Vector3f sum = new Vector3f();
        for (int column = 0; column < width(); column++) {
            sum.add(value(row, column, 0), value(row, column, 1), value(row, column, 2));
        }
        return sum.div(width());
    }

    /** Returns lights that together stand for the map. */
    public synchronized LightTree lights() {
        if (tree == null) {
            tree = LightTree.of(this, LightTree.FINEST);
        }
        return tree;
    }
}
