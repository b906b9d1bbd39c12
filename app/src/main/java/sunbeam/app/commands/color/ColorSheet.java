package sunbeam.app.commands.color;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.Plot;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.units.Decimals;

/** The picture: a pair of strips for each surface, the chromaticities and the spectra. */
final class ColorSheet {
    private static final int WIDTH = 1280;
    private static final int LEFT = 130;
    private static final int RIGHT = 30;
    private static final int STRIP = 64;
    private static final int ROW = 14;
    private static final int GAP = 34;
    private static final int TITLE = 30;
    private static final int PLOT_HEIGHT = 520;
    private static final Color INK = new Color(0x222222);

    private final List<ColorReport> reports;
    private final double exposure;
    private final CieTable cie;

    ColorSheet(List<ColorReport> reports, double exposure, CieTable cie) {
        this.reports = reports;
        this.exposure = exposure;
        this.cie = cie;
    }

    BufferedImage draw() {
        int top = reports.stream().mapToInt(ColorSheet::height).sum();
        BufferedImage image = new BufferedImage(WIDTH, top + PLOT_HEIGHT + TITLE, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, WIDTH, image.getHeight());
        int y = 0;
        for (ColorReport report : reports) {
            surface(graphics, report, y);
            y += height(report);
        }
        graphics.drawImage(chromaticities(), 0, y, null);
        graphics.drawImage(spectra(), WIDTH / 2, y, null);
        graphics.setColor(INK);
        graphics.setFont(font(Font.PLAIN, 14));
        graphics.drawString(
                String.format(Locale.ROOT, "one exposure for all: %.4g; angles in degrees to the normal", exposure),
                LEFT,
                image.getHeight() - 10);
        graphics.dispose();
        return image;
    }

    private static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }

    private static int stripHeight(ColorReport report) {
        return report.thetas().size() == 1 ? STRIP : ROW * report.thetas().size();
    }

    private static int height(ColorReport report) {
        return TITLE + 2 * (stripHeight(report) + GAP);
    }

    private void surface(Graphics2D graphics, ColorReport report, int top) {
        graphics.setColor(INK);
        graphics.setFont(font(Font.BOLD, 15));
        List<Double> thetas = report.thetas();
        String light = thetas.size() == 1
                ? angle(thetas.get(0))
                : angle(thetas.get(0)) + " (top) to " + angle(thetas.get(thetas.size() - 1)) + " (bottom)";
        graphics.drawString(
                String.format(
                        Locale.ROOT,
                        "%s: light at %s, azimuth %s; coherence length %s um",
                        report.name(),
                        light,
                        angle(report.lightAzimuthDegrees()),
                        Decimals.format(Math.round(report.coherenceLength() * 1e8) / 100.0)),
                LEFT,
                top + 20);
        strip(graphics, report, true, top + TITLE);
        strip(graphics, report, false, top + TITLE + stripHeight(report) + GAP);
    }

    private static String angle(double degrees) {
        return Decimals.format(Math.round(degrees * 10) / 10.0 + 0.0) + "\u00b0";
    }

    private void strip(Graphics2D graphics, ColorReport report, boolean along, int top) {
        int width = WIDTH - LEFT - RIGHT;
        int height = stripHeight(report);
        int rows = report.thetas().size();
        for (int row = 0; row < rows; row++) {
            List<SeenColor> colours = report.strip(along, report.thetas().get(row));
            int count = colours.size();
            for (int i = 0; i < count; i++) {
                int from = LEFT + i * width / count;
                graphics.setColor(new Color(colours.get(i).rgb()));
                graphics.fillRect(
                        from, top + row * height / rows, LEFT + (i + 1) * width / count - from, height / rows);
            }
        }
        graphics.setColor(INK);
        graphics.setFont(font(Font.PLAIN, 13));
        double azimuth = report.azimuthDegrees() + (along ? 0 : 90);
        graphics.drawString(along ? "along" : "across", 12, top + height / 2 - 4);
        graphics.drawString("azimuth " + angle(azimuth), 12, top + height / 2 + 14);
        int largest = ColorStrips.LARGEST_VIEW_DEGREES;
        for (int degrees = -largest; degrees <= largest; degrees += 20) {
            int x = LEFT + (int) Math.round((degrees + largest) * (double) width / (2 * largest));
            graphics.drawLine(x, top + height, x, top + height + 4);
            String label = degrees + "\u00b0";
            graphics.drawString(label, x - graphics.getFontMetrics().stringWidth(label) / 2, top + height + 18);
        }
    }

    /** The locus of spectral light, white, and each surface's colours along its strongest direction. */
    private BufferedImage chromaticities() {
        List<Chromaticity> locus = new ArrayList<>(IntStream.rangeClosed(380, 700)
                .mapToObj(nanometre -> Chromaticity.ofWavelength(cie, nanometre * 1e-9))
                .toList());
        locus.add(locus.get(0));
        Plot plot = new Plot(new Plot.Frame(
                "Chromaticity, along",
                Plot.Axis.linear("x (CIE 1931)"),
                Plot.Axis.linear("y"),
                WIDTH / 2,
                PLOT_HEIGHT));
        plot.line("spectral colours", xs(locus), ys(locus));
        for (ColorReport report : reports) {
            List<Chromaticity> seen = report.colours().stream()
                    .filter(colour -> colour.view().along() && colour.xyz()[1] > 0)
                    .map(SeenColor::chromaticity)
                    .toList();
            if (!seen.isEmpty()) {
                plot.points(report.name(), xs(seen), ys(seen));
            }
        }
        List<Chromaticity> white = List.of(Chromaticity.WHITE);
        plot.rings("white (D65)", xs(white), ys(white));
        return plot.draw();
    }

    private static double[] xs(List<Chromaticity> points) {
        return points.stream().mapToDouble(Chromaticity::x).toArray();
    }

    private static double[] ys(List<Chromaticity> points) {
        return points.stream().mapToDouble(Chromaticity::y).toArray();
    }

    private BufferedImage spectra() {
        Plot plot = new Plot(new Plot.Frame(
                "Relative radiance, along",
                Plot.Axis.linear("wavelength / nm"),
                Plot.Axis.linear("share of its spectrum's maximum"),
                WIDTH / 2,
                PLOT_HEIGHT));
        for (ColorReport report : reports) {
            for (ColorReport.SeenSpectrum spectrum : report.spectra()) {
                double[] nanometres = new double[spectrum.wavelengths().length];
                double[] shares = new double[nanometres.length];
                double largest = Double.MIN_NORMAL;
                for (double value : spectrum.radiances()) {
                    largest = Math.max(largest, value);
                }
                for (int i = 0; i < nanometres.length; i++) {
                    nanometres[i] = spectrum.wavelengths()[i] * 1e9;
                    shares[i] = spectrum.radiances()[i] / largest;
                }
                plot.line(report.name() + " " + angle(spectrum.view().thetaRDegrees()), nanometres, shares);
            }
        }
        return plot.draw();
    }
}
