package sunbeam.app.files.output;

import java.nio.file.Path;
import java.util.Locale;
import sunbeam.precompute.color.Srgb;

/** Linear colors as files of two kinds, by their names' endings ({@link Ending#LINEAR}). */
public final class LinearFile {
    private static final String COMMENTS =
            "linear Rec. 709 (white of D65) before exposure: of maps relative radiance, 1 for a flat"
                    + " mirror of the material in specular direction; negative outside of the gamut";

    private LinearFile() {}

    /**
     * The content of a file: of {@code .npy} CIE XYZ, NaN where there is no surface; of {@code .exr} linear Rec. 709 with alpha, 32-bit floats.
     *
     * @param xyz {@code height x width x 3}, row 0 on top, NaN where there is no surface
     */
    public static AtomicFile.StreamContent of(Path file, float[] xyz, int width, int height) {
        boolean isExr = file.toString().toLowerCase(Locale.ROOT).endsWith(".exr");
        return isExr
                ? stream -> ExrFile.ofFloats(width, height, rgba(xyz), COMMENTS).write(stream)
                : stream -> NpyWriter.write(stream, xyz, height, width, 3);
    }

    /** Linear Rec. 709 and alpha, 1 where there is a surface, of each pixel's XYZ. */
    static float[] rgba(float[] xyz) {
        float[] rgba = new float[xyz.length / 3 * 4];
        for (int pixel = 0; pixel < xyz.length / 3; pixel++) {
            int at = 3 * pixel;
            if (!Float.isNaN(xyz[at + 1])) {
                for (int c = 0; c < 3; c++) {
                    rgba[4 * pixel + c] = (float) Srgb.linear(c, xyz[at], xyz[at + 1], xyz[at + 2]);
                }
                rgba[4 * pixel + 3] = 1;
            }
        }
        return rgba;
    }
}
