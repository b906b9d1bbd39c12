package sunbeam.app.cli.precompute;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.BandTransform2d;
import sunbeam.precompute.spectrum.ComplexVector;

/**
 * Figure 3.1 of the thesis: inverse DFT of powers (i h)^n of the heights h, in micrometers above the lowest. Red shows real parts and green
 * imaginary parts, logarithmically: mid-gray is 0, and the extremes are 0 and 255. A plot shows the magnitudes of these extremes over n.
 */
record FourierImages(HeightMap map) {
    private static final int SIDE = 300;
    private static final int CAPTION = 28;
    private static final int GAP = 12;
    private static final int PLOT_WIDTH = 640;
    private static final double MICROMETERS = 1e6;

    /** Smallest magnitude that differs from 0 in an image, relative to the largest real or imaginary part. */
    private static final double SPAN = 1e-4;

    /** Magnitude below which an extreme is a rounding error, relative to the largest one of its power. */
    private static final double ROUNDING = 1e-12;

    private static final int RED = 1;
    private static final int GREEN = 2;

    /** @param largest largest magnitude of a real or imaginary part of each power from 0 on; 0 for powers that were not transformed */
    record Result(BufferedImage picture, double[] largest) {}

    /** @param powers exponents n, ascending; with more than one, a plot of the extremes for n from 0 to the last is added */
    Result draw(List<Integer> powers) {
        boolean plotted = powers.size() > 1;
        int width = powers.size() * (SIDE + GAP) - GAP + (plotted ? GAP + PLOT_WIDTH : 0);
        double[][] extremes = new double[4][powers.get(powers.size() - 1) + 1];
        BufferedImage picture = new Sheet(width)
                .part(SIDE + CAPTION, graphics -> draw(graphics, powers, extremes, width))
                .draw();
        return new Result(
                picture,
                IntStream.range(0, extremes[0].length)
                        .mapToDouble(n -> largest(extremes, n))
                        .toArray());
    }

    private static double largest(double[][] extremes, int n) {
        return Arrays.stream(extremes)
                .mapToDouble(values -> Math.abs(values[n]))
                .max()
                .orElseThrow();
    }

    private void draw(Graphics2D graphics, List<Integer> powers, double[][] extremes, int width) {
        boolean plotted = powers.size() > 1;
        int last = extremes[0].length - 1;
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
                graphics.drawImage(image(bins, largest(extremes, n)), place, 0, SIDE, SIDE, null);
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

    /** Draws, for each pixel, the bin of largest magnitude in it; frequency 0 is in the middle, y points up. */
    private BufferedImage image(ComplexVector bins, double largest) {
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
        for (int i = 0; i < strongest.length; i++) {
            int rgb = channel(bins.real()[strongest[i]] / largest) << 16
                    | channel(bins.imaginary()[strongest[i]] / largest) << 8;
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

    private static int channel(double value) {
        double brightness = Math.log(Math.max(1, Math.abs(value) / SPAN)) / Math.log(1 / SPAN);
        return (int) Math.round(127.5 * (1 + Math.copySign(brightness, value)));
    }

    private static BufferedImage plot(double[][] extremes) {
        double[] powers =
                IntStream.range(0, extremes[0].length).asDoubleStream().toArray();
        double[][] magnitudes = Arrays.stream(extremes)
                .map(values -> IntStream.range(0, values.length)
                        .mapToDouble(n -> Math.abs(values[n]))
                        .toArray())
                .toArray(double[][]::new);
        for (double[] values : magnitudes) {
            Arrays.setAll(values, n -> values[n] > ROUNDING * largest(extremes, n) ? values[n] : Double.NaN);
        }
        return new Plot(new Plot.Frame(
                        "Extreme values",
                        Plot.Axis.linear("power n"),
                        Plot.Axis.logarithmic("|DFT of (i h)^n| / um^n"),
                        PLOT_WIDTH,
                        SIDE + CAPTION))
                .line("greatest real", powers, magnitudes[1], RED)
                .points("least real", powers, magnitudes[0], RED)
                .line("greatest imaginary", powers, magnitudes[3], GREEN)
                .points("least imaginary", powers, magnitudes[2], GREEN)
                .draw();
    }
}
