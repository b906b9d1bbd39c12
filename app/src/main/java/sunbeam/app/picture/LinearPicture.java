package sunbeam.app.picture;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.color.DisplayTransform;

/** Linear CIE XYZ per pixel: {@code height * width * 3} values, row 0 on top, NaN where there is no surface. */
public record LinearPicture(int width, int height, float[] xyz) {
    /** Luminance, relative to the screen's white, that the brighter half of a picture has in the mean after {@link #exposure}. */
    public static final double EXPOSURE_TARGET = 0.42;

    private static final double DARKER = 0.5;

    /** Sets pixels from {@code first} on to RGBA of a render target; alpha 0 means no surface. */
    public void setRgba(int first, float[] rgba) {
        for (int i = 0; i < rgba.length / 4; i++) {
            boolean covered = rgba[4 * i + 3] > 0;
            for (int c = 0; c < 3; c++) {
                xyz[3 * (first + i) + c] = covered ? rgba[4 * i + c] : Float.NaN;
            }
        }
    }

    /** Adds another picture of the same size to this one, and returns this. */
    public LinearPicture plus(LinearPicture other) {
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] += other.xyz[i];
        }
        return this;
    }

    public boolean covered(int pixel) {
        return !Float.isNaN(xyz[3 * pixel + 1]);
    }

    public float luminance(int pixel) {
        return xyz[3 * pixel + 1];
    }

    /** Returns the picture in sRGB; transparent where there is no surface. */
    public BufferedImage shown(DisplayTransform display) {
        boolean opaque = IntStream.range(0, width * height).allMatch(this::covered);
        BufferedImage image =
                new BufferedImage(width, height, opaque ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
        int[] argb = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        IntStream.range(0, height).parallel().forEach(row -> {
            double[] light = new double[3];
            for (int pixel = row * width; pixel < (row + 1) * width; pixel++) {
                if (covered(pixel)) {
                    display.light(xyz, 3 * pixel, light);
                    argb[pixel] = 0xff000000 | DisplayTransform.packed(light);
                }
            }
        });
        return image;
    }

    /**
     * Returns one automatic exposure for all pictures, a factor of linear XYZ (docs/theory.md); 1 for pictures without light. Ignores
     * pixels whose Y is NaN, infinite, zero or negative.
     *
     * <p>Pixels are weighted by lightness, the cube root of Y (CIE 1976), so that black has no weight. The geometric mean Y of the
     * brightest ones with half of the total weight becomes {@link #EXPOSURE_TARGET}: unlike a percentile, it changes little if the picture
     * changes little.
     */
    public static double exposure(LinearPicture... pictures) {
        float[] luminances = new float
                [Arrays.stream(pictures)
                        .mapToInt(picture -> picture.width * picture.height)
                        .reduce(0, Math::addExact)];
        int count = 0;
        for (LinearPicture picture : pictures) {
            for (int pixel = 0; pixel < picture.width * picture.height; pixel++) {
                float luminance = picture.luminance(pixel);
                if (luminance > 0 && Float.isFinite(luminance)) {
                    luminances[count++] = luminance;
                }
            }
        }
        Arrays.parallelSort(luminances, 0, count);
        double[] roots = new double[count];
        Arrays.parallelSetAll(roots, i -> Math.cbrt(luminances[i]));
        double all = Arrays.stream(roots).sum();
        if (!(all > 0)) {
            return 1;
        }
        double below = 0;
        double logarithms = 0;
        double weights = 0;
        for (int i = 0; i < roots.length; i++) {
            double upTo = below + roots[i] / all;
            double weight = upTo - Math.max(below, DARKER);
            if (weight > 0) {
                logarithms += weight * Math.log(luminances[i]);
                weights += weight;
            }
            below = upTo;
        }
        return EXPOSURE_TARGET / Math.exp(logarithms / weights);
    }
}
