package sunbeam.app.gpu.picture;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.text.Text;

/** Median and 95th percentile of CIEDE2000 between two pictures, over pixels where either is not black. */
public record PictureDifference(double median, double high) {

    /** Compares pixels over the area of the base, which must not exceed the picture. */
    public static PictureDifference of(BufferedImage picture, BufferedImage base) {
        double[] differences = new double[base.getWidth() * base.getHeight()];
        int count = 0;
        for (int y = 0; y < base.getHeight(); y++) {
            for (int x = 0; x < base.getWidth(); x++) {
                int color = picture.getRGB(x, y) & 0xffffff;
                int first = base.getRGB(x, y) & 0xffffff;
                if (color != 0 || first != 0) {
                    differences[count++] = CieLab.ofSrgb(color).difference(CieLab.ofSrgb(first));
                }
            }
        }
        double[] counted = count == 0 ? new double[1] : Arrays.copyOf(differences, count);
        return new PictureDifference(Quantiles.of(counted, 0.5), Quantiles.of(counted, 0.95));
    }

    public String text() {
        return Text.format("CIEDE2000 %.2g (median), %.2g (95th percentile)", median, high);
    }
}
