package sunbeam.app.commands.compare;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.color.Srgb;

/**
 * Linear CIE XYZ of a photograph's samples, Y = 1 for white: the sum over its channels of what each sample gives. That holds for
 * sRGB and for ICC profiles of curves and a matrix, which those of cameras and screens are.
 *
 * @param xyz {@code [channel][3 * sample + c]}
 */
record SampleLight(float[][] xyz) {
    /** From the white of profiles, D50, to D65: Bradford's transform (B. Lindbloom, "Chromatic Adaptation"). */
    private static final double[][] D50_TO_D65 = {
        {0.9555766, -0.0230393, 0.0631636}, {-0.0282895, 1.0099416, 0.0210077}, {0.0122982, -0.0204830, 1.3299098}
    };
    /** Of X, Y, Z: profiles have numbers of 16 bits, and their curves are interpolated. */
    private static final double PROFILE_ERROR = 2e-3;

    /**
     * @param image of 8 or 16 bits, gray or of three channels
     * @param space of its colors
     * @throws InputException for others, and for a profile that mixes channels in another way
     */
    static SampleLight of(Path file, BufferedImage image, ColorSpace space) {
        int type = image.getRaster().getTransferType();
        int channels = image.getColorModel().getNumColorComponents();
        boolean isWhole = type == DataBuffer.TYPE_BYTE || type == DataBuffer.TYPE_USHORT || type == DataBuffer.TYPE_INT;
        if (!isWhole || image.getSampleModel().getSampleSize(0) > Short.SIZE) {
            throw new InputException("photograph " + file
                    + " has samples that are not of 8 or 16 bits; export it as PNG or TIFF of 16 bits");
        }
        if ((channels != 1 && channels != 3) || space.getNumComponents() != channels) {
            throw new InputException("photograph " + file + " has " + channels + " channels of color and a profile for "
                    + space.getNumComponents() + "; convert it to sRGB");
        }
        // Java takes gray samples for linear light; files hold them as the sRGB curve gives them.
        boolean standard = space.isCS_sRGB() || space == ColorSpace.getInstance(ColorSpace.CS_GRAY);
        if (!standard && !isSum(space)) {
            throw new InputException(
                    "photograph " + file + " has a profile that is more than curves and a matrix; convert it to sRGB");
        }
        float[][] xyz = new float[channels][];
        for (int channel = 0; channel < channels; channel++) {
            int white = (1 << image.getSampleModel().getSampleSize(channel)) - 1;
            xyz[channel] = new float[3 * (white + 1)];
            for (int sample = 0; sample <= white; sample++) {
                double share = (double) sample / white;
                double[] light = standard ? standard(channels, channel, share) : profiled(space, channel, share);
                for (int c = 0; c < 3; c++) {
                    xyz[channel][3 * sample + c] = (float) light[c];
                }
            }
        }
        return new SampleLight(xyz);
    }

    private static double[] standard(int channels, int channel, double share) {
        double[] rgb = new double[3];
        Arrays.fill(rgb, channels == 1 ? 0 : channel, channels == 1 ? 3 : channel + 1, Srgb.linear(255 * share));
        return Srgb.xyz(rgb[0], rgb[1], rgb[2]);
    }

    private static double[] profiled(ColorSpace space, int channel, double share) {
        float[] color = new float[space.getNumComponents()];
        color[channel] = (float) share;
        float[] light = space.toCIEXYZ(color);
        double[] xyz = new double[3];
        for (int c = 0; c < 3; c++) {
            double[] row = D50_TO_D65[c];
            xyz[c] = row[0] * light[0] + row[1] * light[1] + row[2] * light[2];
        }
        return xyz;
    }

    /** Whether some colors are the sums of their channels. */
    private static boolean isSum(ColorSpace space) {
        int channels = space.getNumComponents();
        float[][] colors = {{0, 0, 0}, {1, 1, 1}, {0.2f, 0.5f, 0.8f}, {0.8f, 0.2f, 0.5f}};
        for (float[] color : colors) {
            float[] mixed = space.toCIEXYZ(Arrays.copyOf(color, channels));
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                for (int channel = 0; channel < channels; channel++) {
                    float[] alone = new float[channels];
                    alone[channel] = color[channel];
                    sum += space.toCIEXYZ(alone)[c];
                }
                if (Math.abs(sum - mixed[c]) > PROFILE_ERROR) {
                    return false;
                }
            }
        }
        return true;
    }

    /** How many channels of color a sample has; alpha may follow. */
    int channels() {
        return xyz.length;
    }

    int white(int channel) {
        return xyz[channel].length / 3 - 1;
    }

    /** Adds X, Y, Z of a pixel's samples, times a weight, to {@code sum} from {@code to} on. */
    void add(int[] samples, float weight, float[] sum, int to) {
        for (int channel = 0; channel < xyz.length; channel++) {
            for (int c = 0; c < 3; c++) {
                sum[to + c] += weight * xyz[channel][3 * samples[channel] + c];
            }
        }
    }
}
