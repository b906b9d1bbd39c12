package sunbeam.app.picture;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.text.Text;

/** Median and 95th percentile of CIEDE2000 between two pictures, over pixels where either is not black. */
public record PictureDifference(double median, double high) {
    private static final int RGB = 0xffffff;

    /** Compares pixels over the area of the base, which must not exceed the picture. */
    public static PictureDifference of(BufferedImage picture, BufferedImage base) {
        int width = base.getWidth();
        double[] differences = IntStream.range(0, width * base.getHeight())
                .filter(i -> ((picture.getRGB(i % width, i / width) | base.getRGB(i % width, i / width)) & RGB) != 0)
                .mapToDouble(i -> CieLab.ofSrgb(picture.getRGB(i % width, i / width) & RGB)
                        .difference(CieLab.ofSrgb(base.getRGB(i % width, i / width) & RGB)))
                .toArray();
        double[] counted = differences.length == 0 ? new double[1] : differences;
        return new PictureDifference(Quantiles.of(counted, 0.5), Quantiles.of(counted, 0.95));
    }

    public String text() {
        return Text.format("CIEDE2000 %.2g (median), %.2g (95th percentile)", median, high);
    }
}
