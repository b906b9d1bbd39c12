package sunbeam.app.commands.figures;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import javax.imageio.ImageIO;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.numerics.Quantiles;

/**
 * How far a picture looks from another of its size, where either is not black.
 *
 * @param median CIEDE2000
 * @param high its 95th percentile
 */
record PictureDifference(double median, double high) {

    /** @throws InputException for a file that is no picture */
    static PictureDifference of(Path one, Path other) {
        BufferedImage picture = read(one);
        BufferedImage base = read(other);
        double[] differences = new double[base.getWidth() * base.getHeight()];
        int count = 0;
        for (int y = 0; y < base.getHeight(); y++) {
            for (int x = 0; x < base.getWidth(); x++) {
                int color = picture.getRGB(x, y) & 0xffffff;
                int first = base.getRGB(x, y) & 0xffffff;
                if (color != 0 || first != 0) {
                    differences[count++] = ColorDifference.ciede2000(lab(color), lab(first));
                }
            }
        }
        double[] counted = count == 0 ? new double[1] : Arrays.copyOf(differences, count);
        return new PictureDifference(Quantiles.of(counted, 0.5), Quantiles.of(counted, 0.95));
    }

    private static CieLab lab(int rgb) {
        double[] xyz = Srgb.xyz(Srgb.linear(rgb >> 16), Srgb.linear(rgb >> 8 & 255), Srgb.linear(rgb & 255));
        return CieLab.ofXyz(xyz[0], xyz[1], xyz[2]);
    }

    private static BufferedImage read(Path file) {
        try {
            BufferedImage image = ImageIO.read(file.toFile());
            if (image == null) {
                throw new InputException("cannot read " + file + ": it is no picture; remove it");
            }
            return image;
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    String text() {
        return String.format(
                Locale.ROOT, "CIEDE2000 %.2g (median), %.2g (95th percentile) from the first", median, high);
    }
}
