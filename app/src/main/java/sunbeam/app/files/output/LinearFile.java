package sunbeam.app.files.output;

import java.nio.file.Path;
import sunbeam.precompute.color.Srgb;

/** Writer of linear colors as .npy or .exr ({@link Ending#LINEAR}). */
public final class LinearFile {
    private static final String COMMENTS =
            "linear Rec. 709 (white of D65) before exposure: of maps relative radiance, 1 for a flat"
                    + " mirror of the material in specular direction; negative outside of the gamut";

    private LinearFile() {}

    /** Returns {@code height x width x 3} CIE XYZ, NaN without surface, for {@code .npy}; linear Rec. 709 with alpha for {@code .exr}. */
    public static StreamContent of(Path file, float[] xyz, int width, int height) {
        return Ending.of(file).equals("exr")
                ? stream -> ExrFile.ofFloats(width, height, rgba(xyz), COMMENTS).write(stream)
                : stream -> NpyWriter.write(stream, xyz, height, width, 3);
    }

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
