package sunbeam.app.gpu.picture;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.color.DisplayTransform;

/** Linear CIE XYZ per pixel: {@code height * width * 3} values, row 0 on top, NaN where there is no surface. */
public record LinearPicture(int width, int height, float[] xyz) {
    /** Display luminance of the brighter half's mean; white is 1. Orders several times brighter are compressed. */
    public static final double EXPOSURE_TARGET = 0.42;

    private static final double DARKER = 0.5;

    /** Converts RGBA of a render target; alpha 0 means no surface. */
    public static LinearPicture ofRgba(int width, int height, float[] rgba) {
        float[] xyz = new float[3 * width * height];
        for (int i = 0; i < width * height; i++) {
            boolean covered = rgba[4 * i + 3] > 0;
            for (int c = 0; c < 3; c++) {
                xyz[3 * i + c] = covered ? rgba[4 * i + c] : Float.NaN;
            }
        }
        return new LinearPicture(width, height, xyz);
    }

    public boolean covered(int pixel) {
        return !Float.isNaN(xyz[3 * pixel + 1]);
    }

    public float luminance(int pixel) {
        return xyz[3 * pixel + 1];
    }

    /** Returns the picture in sRGB; transparent where there is no surface. */
    public BufferedImage shown(DisplayTransform display) {
        int[] argb = new int[width * height];
        IntStream.range(0, height).parallel().forEach(row -> {
            double[] light = new double[3];
            for (int pixel = row * width; pixel < (row + 1) * width; pixel++) {
                if (covered(pixel)) {
                    display.light(xyz, 3 * pixel, light);
                    argb[pixel] = 0xff000000 | DisplayTransform.packed(light);
                }
            }
        });
        boolean opaque = IntStream.range(0, argb.length).allMatch(this::covered);
        BufferedImage image =
                new BufferedImage(width, height, opaque ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
        image.getRaster().setDataElements(0, 0, width, height, argb);
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
        double[] luminances = Arrays.stream(pictures)
                .flatMapToDouble(picture ->
                        IntStream.range(0, picture.width * picture.height).mapToDouble(picture::luminance))
                .filter(luminance -> luminance > 0 && Double.isFinite(luminance))
                .sorted()
                .toArray();
        double[] roots = Arrays.stream(luminances).map(Math::cbrt).toArray();
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
