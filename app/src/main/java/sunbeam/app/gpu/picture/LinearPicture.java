package sunbeam.app.gpu.picture;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import sunbeam.precompute.color.DisplayTransform;

/**
 * Linear CIE XYZ per pixel; NaN where there is no surface.
 *
 * @param xyz {@code height * width * 3} values, row 0 on top
 */
public record LinearPicture(int width, int height, float[] xyz) {

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
}
