package sunbeam.app.commands.render;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** 256 colours for all frames of an animation, by median cut (Heckbert 1982) over colours of 5 bits a channel. */
final class Palette {
    private static final int COLORS = 256;
    private static final int BITS = 5;
    private static final int CELLS = 1 << (3 * BITS);

    private final long[] counts = new long[CELLS];
    private final long[][] sums = new long[3][CELLS];
    private final int[] indexOfCell = new int[CELLS];

    /** Counts an image's colours. */
    void add(BufferedImage image) {
        int[] pixels = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        for (int rgb : pixels) {
            int cell = cell(rgb);
            counts[cell]++;
            for (int c = 0; c < 3; c++) {
                sums[c][cell] += (rgb >> (8 * (2 - c))) & 0xff;
            }
        }
    }

    /** Chooses the colours; no more images after this. */
    IndexColorModel choose() {
        List<Box> boxes = new ArrayList<>();
        List<Integer> used = new ArrayList<>();
        for (int cell = 0; cell < CELLS; cell++) {
            if (counts[cell] > 0) {
                used.add(cell);
            }
        }
        boxes.add(new Box(used));
        while (boxes.size() < COLORS) {
            Box widest = boxes.stream()
                    .max(Comparator.comparingDouble(Box::priority))
                    .orElseThrow();
            if (widest.cells.size() < 2) {
                break;
            }
            boxes.remove(widest);
            boxes.addAll(widest.split());
        }
        byte[][] channels = new byte[3][boxes.size()];
        for (int i = 0; i < boxes.size(); i++) {
            for (int cell : boxes.get(i).cells) {
                indexOfCell[cell] = i;
            }
            for (int c = 0; c < 3; c++) {
                channels[c][i] = (byte) Math.round(boxes.get(i).mean(c));
            }
        }
        return new IndexColorModel(8, boxes.size(), channels[0], channels[1], channels[2]);
    }

    /** An image in the colours that {@link #choose} gave; it must have been counted before. */
    BufferedImage apply(BufferedImage image, IndexColorModel colors) {
        int width = image.getWidth();
        BufferedImage indexed = new BufferedImage(width, image.getHeight(), BufferedImage.TYPE_BYTE_INDEXED, colors);
        for (int y = 0; y < image.getHeight(); y++) {
            int[] row = image.getRGB(0, y, width, 1, null, 0, width);
            for (int x = 0; x < width; x++) {
                row[x] = indexOfCell[cell(row[x])];
            }
            indexed.getRaster().setPixels(0, y, width, 1, row);
        }
        return indexed;
    }

    private static int cell(int rgb) {
        return (((rgb >> 19) & 31) << 10) | (((rgb >> 11) & 31) << 5) | ((rgb >> 3) & 31);
    }

    private static int channel(int cell, int c) {
        return (cell >> (BITS * (2 - c))) & 31;
    }

    /** Colours that become one. */
    private final class Box {
        private final List<Integer> cells;
        private final long pixels;

        Box(List<Integer> cells) {
            this.cells = cells;
            this.pixels = cells.stream().mapToLong(cell -> counts[cell]).sum();
        }

        /** Large for boxes of many pixels that differ much; the root keeps rare but vivid colours alive. */
        double priority() {
            return cells.size() < 2 ? -1 : extent(longest()) * Math.sqrt((double) pixels);
        }

        List<Box> split() {
            int axis = longest();
            List<Integer> sorted = new ArrayList<>(cells);
            sorted.sort(Comparator.comparingInt(cell -> channel(cell, axis)));
            long half = 0;
            int at = 0;
            while (at < sorted.size() - 1 && (at == 0 || 2 * half < pixels)) {
                half += counts[sorted.get(at++)];
            }
            return List.of(new Box(sorted.subList(0, at)), new Box(sorted.subList(at, sorted.size())));
        }

        double mean(int c) {
            return (double) cells.stream().mapToLong(cell -> sums[c][cell]).sum() / pixels;
        }

        private int longest() {
            int axis = 0;
            for (int c = 1; c < 3; c++) {
                axis = extent(c) > extent(axis) ? c : axis;
            }
            return axis;
        }

        private int extent(int c) {
            int low = cells.stream().mapToInt(cell -> channel(cell, c)).min().orElse(0);
            int high = cells.stream().mapToInt(cell -> channel(cell, c)).max().orElse(0);
            return high - low;
        }
    }
}
