package sunbeam.app.cli.export;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;

/** A small gray picture of heights as the address of an image. */
final class ScanPicture {
    private static final int MOST_PIXELS = 240;
    // Share of the lowest and of the highest heights that the gray scale leaves out: a grain of dust would decide it.
    private static final double DUST = 0.001;

    private ScanPicture() {}

    static String of(HeightMap scan) {
        double longer = Math.max(scan.width(), scan.height());
        int width = (int) Math.max(1, Math.round(MOST_PIXELS * scan.width() / longer));
        int height = (int) Math.max(1, Math.round(MOST_PIXELS * scan.height() / longer));
        double[] shown = IntStream.range(0, width * height)
                .mapToDouble(
                        i -> scan.at(middle(i % width, width, scan.columns()), middle(i / width, height, scan.rows())))
                .toArray();
        double low = Quantiles.of(shown, DUST);
        double range = Math.max(Quantiles.of(shown, 1 - DUST) - low, 1e-30);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < shown.length; i++) {
            int gray = (int) Math.round(255 * Math.max(0, Math.min(1, (shown[i] - low) / range)));
            image.getRaster().setSample(i % width, i / width, 0, gray);
        }
        return PageScene.address(image, "png");
    }

    /** Returns the sample below the middle of a pixel. */
    private static int middle(int pixel, int pixels, int samples) {
        return (int) ((pixel + 0.5) * samples / pixels);
    }
}
