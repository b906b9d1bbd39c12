package sunbeam.app.files.plot;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;

/** The matrix of a {@link HeatMap}, pixel by pixel: JFreeChart draws a rectangle for each cell, of which there are millions. */
record HeatMapCells(HeatMap.Values values) {

    void paint(Graphics2D graphics, Rectangle2D area) {
        int width = Math.max(1, (int) Math.round(area.getWidth()));
        int height = Math.max(1, (int) Math.round(area.getHeight()));
        BufferedImage cells = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        // Pixel by pixel through the image's color model takes five times as long.
        int[] pixels = ((DataBufferInt) cells.getRaster().getDataBuffer()).getData();
        int[] columns = edges(width, values.rows()[0].length);
        int[] rows = edges(height, values.rows().length);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double value = values.reduction() == HeatMap.Reduction.LARGEST
                        ? largest(columns, x, rows, height - 1 - y)
                        : values.rows()[middle(rows, height - 1 - y)][middle(columns, x)];
                pixels[y * width + x] = values.colors().map().at(values.colors().position(value));
            }
        }
        graphics.drawImage(cells, (int) Math.round(area.getX()), (int) Math.round(area.getY()), null);
    }

    private static int middle(int[] edges, int pixel) {
        return Math.min(edges[edges.length - 1] - 1, (edges[pixel] + edges[pixel + 1]) / 2);
    }

    private static int[] edges(int pixels, int cells) {
        int[] edges = new int[pixels + 1];
        for (int i = 0; i <= pixels; i++) {
            edges[i] = (int) ((long) i * cells / pixels);
        }
        return edges;
    }

    private double largest(int[] columns, int x, int[] rows, int y) {
        double largest = Double.NEGATIVE_INFINITY;
        for (int row = rows[y]; row < Math.max(rows[y] + 1, rows[y + 1]); row++) {
            for (int column = columns[x]; column < Math.max(columns[x] + 1, columns[x + 1]); column++) {
                largest = Math.max(largest, values.rows()[row][column]);
            }
        }
        return largest;
    }
}
