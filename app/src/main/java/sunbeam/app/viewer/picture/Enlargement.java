package sunbeam.app.viewer.picture;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;

/**
 * Enlarges pictures, linearly between the middles of their pixels; beyond the outermost middles as far as these. Java2D does as much with
 * each pixel's place in 64 bits, for ten times the time. Belongs to one thread.
 */
final class Enlargement {
    // Of a pixel.
    private static final int STEPS = 256;
    private static final int EVEN = 0xff00ff;

    private BufferedImage full;

    /**
     * Enlarges a picture.
     *
     * @param image of {@link BufferedImage#TYPE_INT_RGB}
     * @return of that type; valid until the next call
     */
    BufferedImage of(BufferedImage image, int width, int height) {
        if (full == null || full.getWidth() != width || full.getHeight() != height) {
            full = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        }
        int[] to = pixels(full);
        int[] from = pixels(image);
        int columns = image.getWidth();
        int[] places = places(columns, width);
        // With the last one twice.
        int[] even = new int[columns + 1];
        int[] odd = new int[columns + 1];
        int[] rows = places(image.getHeight(), height);
        for (int y = 0; y < height; y++) {
            int above = rows[y] / STEPS * columns;
            int below = Math.min(above + columns, from.length - columns);
            int share = rows[y] % STEPS;
            for (int x = 0; x < columns; x++) {
                int upper = from[above + x];
                int lower = from[below + x];
                even[x] = mixed(upper & EVEN, lower & EVEN, share) & EVEN;
                odd[x] = mixed((upper >>> 8) & 0xff, (lower >>> 8) & 0xff, share);
            }
            even[columns] = even[columns - 1];
            odd[columns] = odd[columns - 1];
            fill(to, y * width, places, even, odd);
        }
        return full;
    }

    /**
     * A picture with the pixels at its edges twice, so that who enlarges it blends in nothing else: servers of X do where a picture ends.
     *
     * @param image of {@link BufferedImage#TYPE_INT_RGB}
     */
    static BufferedImage padded(BufferedImage image) {
        int columns = image.getWidth();
        int rows = image.getHeight();
        BufferedImage padded = new BufferedImage(columns + 2, rows + 2, BufferedImage.TYPE_INT_RGB);
        int[] from = pixels(image);
        int[] to = pixels(padded);
        for (int y = 0; y < rows + 2; y++) {
            int row = Math.max(0, Math.min(rows - 1, y - 1)) * columns;
            int begin = y * (columns + 2);
            to[begin] = from[row];
            System.arraycopy(from, row, to, begin + 1, columns);
            to[begin + columns + 1] = from[row + columns - 1];
        }
        return padded;
    }

    private static void fill(int[] to, int begin, int[] places, int[] even, int[] odd) {
        for (int x = 0; x < places.length; x++) {
            int place = places[x];
            int left = place / STEPS;
            int share = place % STEPS;
            int redAndBlue = mixed(even[left], even[left + 1], share) & EVEN;
            int green = mixed(odd[left], odd[left + 1], share);
            to[begin + x] = redAndBlue | (green << 8);
        }
    }

    /** Two channels of 8 bits, 16 apart, or one. */
    private static int mixed(int first, int second, int share) {
        return (first * (STEPS - share) + second * share) >>> 8;
    }

    /** Of each of many pixels in a row of few, in steps from the middle of the first; before the last one's. */
    private static int[] places(int few, int many) {
        int[] places = new int[many];
        for (int i = 0; i < many; i++) {
            double place = (i + 0.5) * few / many - 0.5;
            places[i] = (int) Math.round(STEPS * Math.max(0, Math.min(few - 1, place)));
        }
        return places;
    }

    private static int[] pixels(BufferedImage image) {
        return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    }
}
