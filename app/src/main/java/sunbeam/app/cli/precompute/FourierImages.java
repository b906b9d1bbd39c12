package sunbeam.app.cli.precompute;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform2d;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.HeightMap;

/**
 * Figure 3.1 of the thesis: inverse DFT of powers (i h)^n of the heights h, in micrometers above the lowest. Red shows real parts and green
 * imaginary parts, each from its least to its greatest value; a plot shows these extremes over n.
 */
record FourierImages(HeightMap map) {
    private static final int SIDE = 300;
    private static final int CAPTION = 28;
    private static final int GAP = 12;
    private static final int PLOT_WIDTH = 640;
    private static final double MICROMETERS = 1e6;

    /** Range below which a channel is due to rounding errors, relative to the larger range of both. */
    private static final double ROUNDING = 1e-12;

    /** @param powers exponents n, ascending; with more than one, a plot of the extremes for n from 0 to the last is added */
    BufferedImage draw(List<Integer> powers) {
        boolean plotted = powers.size() > 1;
        int width = powers.size() * (SIDE + GAP) - GAP + (plotted ? GAP + PLOT_WIDTH : 0);
        return new Sheet(width)
                .part(SIDE + CAPTION, graphics -> draw(graphics, powers, plotted, width))
                .draw();
    }

    private void draw(Graphics2D graphics, List<Integer> powers, boolean plotted, int width) {
        int last = plotted ? powers.get(powers.size() - 1) : powers.get(0);
        double[][] extremes = new double[4][last + 1];
        for (int n = plotted ? 0 : last; n <= last; n++) {
            ComplexVector bins = transformed(n);
            double[] red = range(bins.real());
            double[] green = range(bins.imaginary());
            extremes[0][n] = red[0];
            extremes[1][n] = red[1];
            extremes[2][n] = green[0];
            extremes[3][n] = green[1];
            int place = powers.indexOf(n) * (SIDE + GAP);
            if (place >= 0) {
                graphics.drawImage(image(bins, red, green), place, 0, SIDE, SIDE, null);
                graphics.drawString("(i h)^" + n, place + 4, SIDE + CAPTION - 9);
            }
        }
        if (plotted) {
            graphics.drawImage(plot(extremes), width - PLOT_WIDTH, 0, null);
        }
    }

    private ComplexVector transformed(int power) {
        double lowest = map.minimum();
        // (i h)^n is real or imaginary, positive or negative, by n modulo 4.
        double sign = power % 4 < 2 ? 1 : -1;
        boolean isReal = power % 2 == 0;
        Band bandX = new Band(-(map.columns() / 2), map.columns());
        Band bandY = new Band(-(map.rows() / 2), map.rows());
        return new BandTransform2d(map.columns(), map.rows(), bandX, bandY).transform((row, real, imaginary) -> {
            for (int column = 0; column < map.columns(); column++) {
                double value = sign * Math.pow(MICROMETERS * (map.at(column, row) - lowest), power);
                real[column] = isReal ? value : 0;
                imaginary[column] = isReal ? 0 : value;
            }
        });
    }

    /** Draws, for each pixel, the bin of largest magnitude among those that fall into it; frequency 0 is in the middle, y points up. */
    private BufferedImage image(ComplexVector bins, double[] red, double[] green) {
        int width = Math.min(SIDE, map.columns());
        int height = Math.min(SIDE, map.rows());
        int[] strongest = new int[width * height];
        Arrays.fill(strongest, -1);
        for (int i = 0; i < bins.length(); i++) {
            int x = (int) ((long) (i % map.columns()) * width / map.columns());
            int y = height - 1 - (int) ((long) (i / map.columns()) * height / map.rows());
            int before = strongest[y * width + x];
            if (before < 0 || strength(bins, i) > strength(bins, before)) {
                strongest[y * width + x] = i;
            }
        }
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        // A channel whose range is within rounding errors is drawn as zero.
        double rounding = ROUNDING * Math.max(red[1] - red[0], green[1] - green[0]);
        for (int i = 0; i < strongest.length; i++) {
            int rgb = channel(bins.real()[strongest[i]], red, rounding) << 16
                    | channel(bins.imaginary()[strongest[i]], green, rounding) << 8;
            image.setRGB(i % width, i / width, rgb);
        }
        return image;
    }

    private static double strength(ComplexVector bins, int i) {
        return Math.hypot(bins.real()[i], bins.imaginary()[i]);
    }

    private static double[] range(double[] values) {
        DoubleSummaryStatistics range = Arrays.stream(values).summaryStatistics();
        return new double[] {range.getMin(), range.getMax()};
    }

    private static int channel(double value, double[] range, double rounding) {
        return range[1] - range[0] > rounding ? (int) Math.round(255 * (value - range[0]) / (range[1] - range[0])) : 0;
    }

    private static BufferedImage plot(double[][] extremes) {
        double[] powers =
                IntStream.range(0, extremes[0].length).asDoubleStream().toArray();
        return Plot.linear("Extreme values", "power n", "DFT of (i h)^n / um^n", PLOT_WIDTH, SIDE + CAPTION)
                .line("least real", powers, extremes[0])
                .line("greatest real", powers, extremes[1])
                .line("least imag.", powers, extremes[2])
                .line("greatest imag.", powers, extremes[3])
                .draw();
    }
}
