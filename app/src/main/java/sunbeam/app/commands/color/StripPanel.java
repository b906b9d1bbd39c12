package sunbeam.app.commands.color;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Locale;
import sunbeam.app.files.plot.FittedNames;
import sunbeam.app.files.plot.PlotColors;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** The two strips of one surface, a row for each light, with the light, the mirror direction and the purest color marked. */
final class StripPanel {
    static final Font TITLE_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 15);
    /** Pixels that a surface's name takes at most in its title: some 32 letters. */
    static final int WIDEST_NAME = 270;

    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
    private static final int LEFT = 130;
    private static final int RIGHT = 30;
    private static final int STRIP = 64;
    private static final int ROW = 14;
    private static final int TITLE = 56;
    private static final int GAP = 36;
    private static final int LARGEST = StripColors.LARGEST_VIEW_DEGREES;
    // A direction whose azimuth is farther off lies beside the strip.
    private static final double IN_PLANE = Math.sin(Math.toRadians(1));
    private static final Color INK = new Color(0x222222);
    private static final Color LIGHT = new Color(0xF0E442);
    private static final Color PUREST = new Color(0xE0E0E0);

    private final ColorReport report;
    private final String name;
    private final int number;
    private final int pictureWidth;

    /**
     * Of a surface.
     *
     * @param name as it is shown
     * @param number of the surface, whose color its name has
     * @param pictureWidth in pixels
     */
    StripPanel(ColorReport report, String name, int number, int pictureWidth) {
        this.report = report;
        this.name = name;
        this.number = number;
        this.pictureWidth = pictureWidth;
    }

    /** In pixels. */
    int height() {
        return TITLE + 2 * (stripHeight() + GAP);
    }

    void draw(Graphics2D graphics, int top) {
        graphics.setColor(PlotColors.of(number));
        graphics.fillRect(LEFT - 20, top + 8, 13, 13);
        graphics.setColor(INK);
        fitted(graphics, name + ": " + report.verdict().sentence(), TITLE_FONT, top + 20);
        fitted(graphics, light(), FONT, top + 40);
        strip(graphics, true, top + TITLE);
        strip(graphics, false, top + TITLE + stripHeight() + GAP);
    }

    private void fitted(Graphics2D graphics, String text, Font font, int baseline) {
        double share = Math.min(1, (pictureWidth - LEFT - RIGHT) / FittedNames.width(text, font));
        graphics.setFont(font.deriveFont((float) share * font.getSize2D()));
        graphics.drawString(text, LEFT, baseline);
    }

    /** The color is that of the strip below and of the tables: at the exposure that all share. */
    String light() {
        List<Double> thetas = report.thetas();
        String to = thetas.size() == 1 ? "" : " (top) to " + angle(thetas.get(thetas.size() - 1)) + " (bottom)";
        String purest = report.purest()
                .map(color -> "; purest (square) " + color.hex() + " at "
                        + angle(color.view().thetaRDegrees()))
                .orElse("");
        return String.format(
                Locale.ROOT,
                "light (yellow) at %s%s, azimuth %s; mirror direction (white)%s; coherence length %s",
                angle(thetas.get(0)),
                to,
                angle(report.lightAzimuthDegrees()),
                purest,
                Lengths.rounded(report.coherenceLength(), 3));
    }

    /** An angle for people. */
    static String angle(double degrees) {
        return Decimals.format(Math.round(degrees * 10) / 10.0 + 0.0) + "\u00b0";
    }

    private int stripHeight() {
        return Math.max(STRIP, ROW * report.thetas().size());
    }

    private int x(double degrees) {
        double inside = Math.max(-LARGEST, Math.min(LARGEST, degrees));
        return LEFT + (int) Math.round((inside + LARGEST) * (pictureWidth - LEFT - RIGHT) / (2 * LARGEST));
    }

    private void strip(Graphics2D graphics, boolean along, int top) {
        int height = stripHeight();
        int rows = report.thetas().size();
        for (int row = 0; row < rows; row++) {
            double theta = report.thetas().get(row);
            int from = top + row * height / rows;
            int to = top + (row + 1) * height / rows;
            cells(graphics, report.strip(along, theta), from, to);
            marks(graphics, along, theta, (from + to) / 2);
        }
        graphics.setColor(INK);
        graphics.setFont(FONT);
        double azimuth = report.order().plane().azimuthDegrees() + (along ? 0 : 90);
        graphics.drawString(along ? "along" : "across", 12, top + height / 2 - 4);
        graphics.drawString("azimuth " + angle(azimuth), 12, top + height / 2 + 14);
        for (int degrees = -LARGEST; degrees <= LARGEST; degrees += 20) {
            int x = x(degrees);
            graphics.drawLine(x, top + height, x, top + height + 4);
            String label = degrees + "\u00b0";
            graphics.drawString(label, x - graphics.getFontMetrics().stringWidth(label) / 2, top + height + 18);
        }
    }

    /** Each color reaches half way to its neighbors' angles. */
    private void cells(Graphics2D graphics, List<SeenColor> colors, int top, int bottom) {
        double step =
                colors.get(1).view().thetaRDegrees() - colors.get(0).view().thetaRDegrees();
        for (SeenColor color : colors) {
            int from = x(color.view().thetaRDegrees() - step / 2);
            int to = x(color.view().thetaRDegrees() + step / 2);
            graphics.setColor(new Color(color.rgb()));
            graphics.fillRect(from, top, to - from, bottom - top);
        }
    }

    /** What lies in a strip, on any color to be seen: with a black border. */
    private void marks(Graphics2D graphics, boolean along, double theta, int y) {
        double aside = Math.toRadians(
                report.lightAzimuthDegrees() - report.order().plane().azimuthDegrees() - (along ? 0 : 90));
        if (theta == 0 || Math.abs(Math.sin(aside)) < IN_PLANE) {
            double light = Math.copySign(theta, Math.cos(aside));
            dot(graphics, x(-light), y, Color.WHITE, 9);
            dot(graphics, x(light), y, LIGHT, 5);
        }
        report.purest()
                .filter(color -> along && color.view().thetaIDegrees() == theta)
                .ifPresent(color -> square(graphics, x(color.view().thetaRDegrees()), y));
    }

    private static void dot(Graphics2D graphics, int x, int y, Color color, int size) {
        graphics.setColor(color);
        graphics.fillOval(x - size / 2, y - size / 2, size, size);
        graphics.setColor(Color.BLACK);
        graphics.drawOval(x - size / 2, y - size / 2, size, size);
    }

    private static void square(Graphics2D graphics, int x, int y) {
        graphics.setColor(PUREST);
        graphics.drawRect(x - 5, y - 5, 10, 10);
        graphics.setColor(Color.BLACK);
        graphics.drawRect(x - 6, y - 6, 12, 12);
    }
}
