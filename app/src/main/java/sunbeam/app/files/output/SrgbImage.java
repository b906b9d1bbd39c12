package sunbeam.app.files.output;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;

/** 8-bit sRGB images (IEC 61966-2-1) from the forms that rendering yields. Row 0 is the top everywhere. */
public final class SrgbImage {
    private static final int CHANNELS = 3;
    private static final int OPAQUE = 0xff000000;

    private SrgbImage() {}

    /**
     * From values that have been through the sRGB curve: clipped to [0, 1] and rounded.
     *
     * @param encoded {@code height x width x 3}; a pixel with a NaN becomes transparent
     * @throws IllegalArgumentException when the array's length does not fit
     */
    public static BufferedImage fromEncoded(int width, int height, float[] encoded) {
        checkLength(width, height, encoded.length, CHANNELS);
        int[] argb = new int[width * height];
        for (int pixel = 0; pixel < argb.length; pixel++) {
            int first = CHANNELS * pixel;
            argb[pixel] = pack(encoded[first], encoded[first + 1], encoded[first + 2]);
        }
        return fromArgb(width, height, argb);
    }

    /**
     * From packed 0xAARRGGBB, not premultiplied. The image has an alpha channel only where a pixel needs it.
     *
     * @param argb {@code height x width}
     * @throws IllegalArgumentException when the array's length does not fit
     */
    public static BufferedImage fromArgb(int width, int height, int[] argb) {
        checkLength(width, height, argb.length, 1);
        boolean opaque = true;
        for (int pixel : argb) {
            opaque &= (pixel & OPAQUE) == OPAQUE;
        }
        int type = opaque ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB;
        BufferedImage image = new BufferedImage(width, height, type);
        // Both types have such integers; setRGB would take each pixel's colours apart.
        int[] pixels = pixels(image);
        if (opaque) {
            for (int pixel = 0; pixel < argb.length; pixel++) {
                pixels[pixel] = argb[pixel] & ~OPAQUE;
            }
        } else {
            System.arraycopy(argb, 0, pixels, 0, argb.length);
        }
        return image;
    }

    private static int[] pixels(BufferedImage image) {
        return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    }

    private static int pack(double red, double green, double blue) {
        if (Double.isNaN(red + green + blue)) {
            return 0;
        }
        return OPAQUE | toByte(red) << 16 | toByte(green) << 8 | toByte(blue);
    }

    private static int toByte(double value) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
    }

    private static void checkLength(int width, int height, int length, int channels) {
        if (width < 1 || height < 1 || length != (long) width * height * channels) {
            throw new IllegalArgumentException(
                    length + " values do not make an image of " + width + " x " + height + " x " + channels);
        }
    }
}
