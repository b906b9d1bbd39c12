package sunbeam.app.files.output;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;

/** 8-bit sRGB images (IEC 61966-2-1) from the forms that rendering yields. Row 0 is the top everywhere. */
public final class SrgbImage {
    private static final int OPAQUE = 0xff000000;

    private SrgbImage() {}

    /**
     * From packed 0xAARRGGBB, not premultiplied. The image has an alpha channel only where a pixel needs it.
     *
     * @param argb {@code height x width}
     * @throws IllegalArgumentException when the array's length does not fit
     */
    public static BufferedImage fromArgb(int width, int height, int[] argb) {
        checkLength(width, height, argb.length);
        boolean opaque = true;
        for (int pixel : argb) {
            opaque &= (pixel & OPAQUE) == OPAQUE;
        }
        int type = opaque ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB;
        BufferedImage image = new BufferedImage(width, height, type);
        // Both types have such integers; setRGB would take each pixel's colors apart.
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

    private static void checkLength(int width, int height, int length) {
        if (width < 1 || height < 1 || length != (long) width * height) {
            throw new IllegalArgumentException(length + " values do not make an image of " + width + " x " + height);
        }
    }
}
