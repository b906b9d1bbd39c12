package sunbeam.app.cli.compare;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.ColorConvertOp;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.files.InputException;

/**
 * Converts a photograph's samples to linear light by an ICC profile, or else by the curve of sRGB, also for gray samples.
 *
 * @param channels number of color channels; an alpha channel may follow in the samples
 * @param white largest value of a sample in these channels
 * @param curve linear light of each value of a sample, 0 to 1, used if there is no conversion
 * @param conversion conversion by the profile to linear sRGB of 16 bits; it clips at the gamut of sRGB, as the comparison does for the
 *     scene
 */
record PhotoColors(Path file, int channels, int white, float[] curve, Optional<ColorConvertOp> conversion) {
    private static final int WHITE_16 = 65_535;

    /**
     * @param space color space of the samples; that of the profile if the file has one
     * @param hasProfile whether the file has a profile; if {@code space} is a standard one nevertheless, the profile was damaged
     * @throws InputException for unknown kinds of samples or color spaces, and for a damaged profile
     */
    static PhotoColors of(Path file, Raster raster, int channels, ColorSpace space, boolean hasProfile) {
        int type = raster.getTransferType();
        int bits = raster.getSampleModel().getSampleSize(0);
        boolean isWhole = type == DataBuffer.TYPE_BYTE || type == DataBuffer.TYPE_USHORT || type == DataBuffer.TYPE_INT;
        if (!isWhole || bits > Short.SIZE) {
            throw new InputException("photograph " + file
                    + " has samples that are not of 8 or 16 bits; export it as PNG or TIFF of 16 bits");
        }
        // Java takes gray samples for linear light, but in files they follow the curve of sRGB.
        boolean isStandard = space.isCS_sRGB() || space == ColorSpace.getInstance(ColorSpace.CS_GRAY);
        if (space.getNumComponents() != channels || !(isStandard || space instanceof ICC_ColorSpace)) {
            throw new InputException("photograph " + file + " has " + channels + " channels of color and a profile for "
                    + space.getNumComponents() + ", or none; convert it to sRGB");
        }
        if (isStandard && hasProfile) {
            throw new InputException("photograph " + file
                    + " has a color profile that is damaged or does not fit its samples; convert it to sRGB");
        }
        int white = (1 << bits) - 1;
        float[] curve = new float[white + 1];
        for (int sample = 0; sample <= white; sample++) {
            curve[sample] = (float) Srgb.linear(255.0 * sample / white);
        }
        if (isStandard) {
            return new PhotoColors(file, channels, white, curve, Optional.empty());
        }
        ICC_Profile linear = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB);
        ICC_Profile[] profiles = {((ICC_ColorSpace) space).getProfile(), linear};
        return new PhotoColors(file, channels, white, curve, Optional.of(new ColorConvertOp(profiles, null)));
    }

    /**
     * Returns the linear light of a row of pixels: red, green and blue of sRGB for each pixel, 0 to 1.
     *
     * @param samples {@code bands} samples for each pixel, those of color first
     */
    float[] linear(int[] samples, int bands) {
        int columns = samples.length / bands;
        float[] light = new float[3 * columns];
        if (conversion.isEmpty()) {
            for (int column = 0; column < columns; column++) {
                for (int c = 0; c < 3; c++) {
                    light[3 * column + c] = curve[samples[bands * column + Math.min(c, channels - 1)]];
                }
            }
            return light;
        }
        int[] scaled = new int[channels * columns];
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] = (int) ((long) samples[i / channels * bands + i % channels] * WHITE_16 / white);
        }
        try {
            WritableRaster from = row(columns, channels);
            from.setPixels(0, 0, columns, 1, scaled);
            int[] converted =
                    conversion.get().filter(from, row(columns, 3)).getPixels(0, 0, columns, 1, new int[light.length]);
            IntStream.range(0, light.length).forEach(i -> light[i] = (float) converted[i] / WHITE_16);
            return light;
        } catch (RuntimeException damaged) {
            // Java reads a profile at its first use, and a damaged one fails with exceptions of many kinds.
            throw new InputException(
                    "photograph " + file + " has a color profile that cannot be used; convert it to sRGB", damaged);
        }
    }

    private static WritableRaster row(int columns, int channels) {
        return Raster.createInterleavedRaster(DataBuffer.TYPE_USHORT, columns, 1, channels, null);
    }
}
