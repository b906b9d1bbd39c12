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

/**
 * How far a picture looks from another of its size, where either is not black.
 *
 * @param median CIEDE2000
 * @param high its 95th percentile
 */
record PictureDifference(double median, double high) {

    static PictureDifference of(BufferedImage picture, BufferedImage base) {
        double[] differences = new double[base.getWidth() * base.getHeight()];
        int count = 0;
        for (int y = 0; y < base.getHeight(); y++) {
            for (int x = 0; x < base.getWidth(); x++) {
                int one = picture.getRGB(x, y) & 0xffffff;
                int other = base.getRGB(x, y) & 0xffffff;
                if (one != 0 || other != 0) {
                    differences[count++] = ColorDifference.ciede2000(lab(one), lab(other));
                }
            }
        }
        Arrays.sort(differences, 0, count);
        return new PictureDifference(at(differences, count, 0.5), at(differences, count, 0.95));
    }

    private static double at(double[] sorted, int count, double share) {
        return count == 0 ? 0 : sorted[(int) (share * (count - 1))];
    }

    private static CieLab lab(int rgb) {
        double[] xyz = Srgb.xyz(Srgb.linear(rgb >> 16), Srgb.linear(rgb >> 8 & 255), Srgb.linear(rgb & 255));
        return CieLab.ofXyz(xyz[0], xyz[1], xyz[2]);
    }

    /** @throws InputException for a file that is no picture */
    static BufferedImage read(Path file) {
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
