package sunbeam.app.commands.figures;

import java.util.Arrays;
import java.util.Locale;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.ColorDifference;

/**
 * How far a map is from another, where that one is visible.
 *
 * @param medianRelative median over the pixels of |XYZ difference| / |XYZ|, largest of the three components over the
 *     largest of the other's
 * @param medianCiede2000 median of the colour difference as displayed, CIEDE2000
 * @param highCiede2000 its 95th percentile
 */
record MapDifference(double medianRelative, double medianCiede2000, double highCiede2000) {
    // Darker pixels are drawn as 13 of 255 or less.
    private static final double VISIBLE = 0.004;

    static MapDifference of(LinearPicture map, LinearPicture base, double exposure) {
        int pixels = map.width() * map.height();
        double[] relative = new double[pixels];
        double[] ciede2000 = new double[pixels];
        int count = 0;
        for (int pixel = 0; pixel < pixels; pixel++) {
            if (base.covered(pixel) && base.luminance(pixel) * exposure > VISIBLE) {
                relative[count] = relative(map, base, pixel);
                ciede2000[count++] =
                        ColorDifference.ciede2000(displayed(map, pixel, exposure), displayed(base, pixel, exposure));
            }
        }
        Arrays.sort(relative, 0, count);
        Arrays.sort(ciede2000, 0, count);
        return new MapDifference(at(relative, count, 0.5), at(ciede2000, count, 0.5), at(ciede2000, count, 0.95));
    }

    private static double at(double[] sorted, int count, double share) {
        return count == 0 ? Double.NaN : sorted[(int) (share * (count - 1))];
    }

    private static double relative(LinearPicture map, LinearPicture base, int pixel) {
        double difference = 0;
        double size = 0;
        for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
            difference = Math.max(difference, Math.abs(map.xyz()[i] - base.xyz()[i]));
            size = Math.max(size, base.xyz()[i]);
        }
        return difference / size;
    }

    /** Light above white is drawn as white. */
    private static CieLab displayed(LinearPicture map, int pixel, double exposure) {
        double scale = exposure / Math.max(1, exposure * map.luminance(pixel));
        return CieLab.ofXyz(
                scale * map.xyz()[3 * pixel], scale * map.xyz()[3 * pixel + 1], scale * map.xyz()[3 * pixel + 2]);
    }

    String text() {
        return String.format(
                Locale.ROOT,
                "differs by %.2g of XYZ (median), CIEDE2000 %.2g (median), %.2g (95th percentile)",
                medianRelative,
                medianCiede2000,
                highCiede2000);
    }
}
