package sunbeam.app.commands.color;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import sunbeam.app.files.plot.FittedNames;
import sunbeam.app.files.plot.PlotColours;
import sunbeam.precompute.units.Decimals;

/**
 * The two strips of one surface, with its light, the mirror direction and its purest colour marked: above a strip of one
 * light by name, in rows of several lights by dots.
 */
final class StripPanel {
    static final Font TITLE_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 15);
    /** Pixels that a surface's name takes at most in its title: some 32 letters. */
    static final int WIDEST_NAME = 270;

    private static final int LEFT = 130;
    private static final int RIGHT = 30;
    private static final int STRIP = 64;
    private static final int ROW = 14;
    private static final int TITLE = 30;
    private static final int MARKS = 22;
    private static final int GAP = 30;
    private static final int LARGEST = ColorStrips.LARGEST_VIEW_DEGREES;
    // A direction whose azimuth is farther off lies beside the strip.
    private static final double IN_PLANE = Math.sin(Math.toRadians(1));
    private static final Color INK = new Color(0x222222);

    private final ColorReport report;
    private final String name;
    private final int number;
    private final int pictureWidth;

    /** What is marked at an angle. */
    private record Mark(String name, double degrees) {}

    /**
     * Of a surface.
     *
     * @param name as it is shown
     * @param number of the surface, whose colour its name has
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
        return TITLE + 2 * (MARKS + stripHeight() + GAP);
    }

    void draw(Graphics2D graphics, int top) {
        graphics.setColor(PlotColours.of(number));
        graphics.fillRect(LEFT - 20, top + 8, 13, 13);
        graphics.setColor(INK);
        String title = title();
        double room = pictureWidth - LEFT - RIGHT;
        double share = Math.min(1, room / FittedNames.width(title, TITLE_FONT));
        graphics.setFont(TITLE_FONT.deriveFont((float) share * TITLE_FONT.getSize2D()));
        graphics.drawString(title, LEFT, top + 20);
        strip(graphics, true, top + TITLE + MARKS);
        strip(graphics, false, top + TITLE + 2 * MARKS + stripHeight() + GAP);
    }

    /** The colour is that of the strip below and of the tables: at the exposure that all share. */
    String title() {
        List<Double> thetas = report.thetas();
        String light = thetas.size() == 1
                ? angle(thetas.get(0))
                : angle(thetas.get(0)) + " (top) to " + angle(thetas.get(thetas.size() - 1)) + " (bottom)";
        String purest = report.purest()
                .map(found -> "purest " + found.colour().shown().hex() + " at "
                        + angle(found.colour().view().thetaRDegrees()))
                .orElse("no order to tell the colour of");
        return name + ": light at " + light + ", azimuth " + angle(report.lightAzimuthDegrees())
                + "; coherence length " + Decimals.format(Math.round(report.coherenceLength() * 1e8) / 100.0) + " um; "
                + purest;
    }

    /** An angle for people. */
    static String angle(double degrees) {
        return Decimals.format(Math.round(degrees * 10) / 10.0 + 0.0) + "\u00b0";
    }

    private int stripHeight() {
        return report.thetas().size() == 1 ? STRIP : ROW * report.thetas().size();
    }

    private int x(double degrees) {
        int width = pictureWidth - LEFT - RIGHT;
        double inside = Math.max(-LARGEST, Math.min(LARGEST, degrees));
        return LEFT + (int) Math.round((inside + LARGEST) * width / (2 * LARGEST));
    }

    private void strip(Graphics2D graphics, boolean along, int top) {
        int height = stripHeight();
        int rows = report.thetas().size();
        for (int row = 0; row < rows; row++) {
            double theta = report.thetas().get(row);
            int from = top + row * height / rows;
            int to = top + (row + 1) * height / rows;
            cells(graphics, report.strip(along, theta), from, to);
            List<Mark> marks = marks(along, theta);
            if (rows == 1) {
                reach(graphics, report.strip(along, theta), top);
                named(graphics, marks, top);
            } else {
                marks.forEach(mark -> dot(graphics, mark, (from + to) / 2));
            }
        }
        graphics.setColor(INK);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        double azimuth = report.direction().azimuthDegrees() + (along ? 0 : 90);
        graphics.drawString(along ? "along" : "across", 12, top + height / 2 - 4);
        graphics.drawString("azimuth " + angle(azimuth), 12, top + height / 2 + 14);
        for (int degrees = -LARGEST; degrees <= LARGEST; degrees += 20) {
            int x = x(degrees);
            graphics.drawLine(x, top + height, x, top + height + 4);
            String label = degrees + "\u00b0";
            graphics.drawString(label, x - graphics.getFontMetrics().stringWidth(label) / 2, top + height + 18);
        }
        if (rows > 1 && along) {
            legend(graphics, top);
        }
    }

    /** A bar above what lies within the mirror's reach. */
    private void reach(Graphics2D graphics, List<SeenColor> colours, int stripTop) {
        double step =
                colours.get(1).view().thetaRDegrees() - colours.get(0).view().thetaRDegrees();
        graphics.setColor(Color.GRAY);
        for (SeenColor colour : colours) {
            if (colour.nearMirror()) {
                int from = x(colour.view().thetaRDegrees() - step / 2);
                graphics.fillRect(from, stripTop - 4, x(colour.view().thetaRDegrees() + step / 2) - from, 3);
            }
        }
    }

    /** Each colour reaches half way to its neighbours' angles. */
    private void cells(Graphics2D graphics, List<SeenColor> colours, int top, int bottom) {
        double step =
                colours.get(1).view().thetaRDegrees() - colours.get(0).view().thetaRDegrees();
        for (SeenColor colour : colours) {
            int from = x(colour.view().thetaRDegrees() - step / 2);
            int to = x(colour.view().thetaRDegrees() + step / 2);
            graphics.setColor(new Color(colour.shown().rgb()));
            graphics.fillRect(from, top, to - from, bottom - top);
        }
    }

    /** Those that lie in a strip, from the left to the right. */
    private List<Mark> marks(boolean along, double theta) {
        List<Mark> marks = new ArrayList<>();
        double aside =
                Math.toRadians(report.lightAzimuthDegrees() - report.direction().azimuthDegrees() - (along ? 0 : 90));
        if (theta == 0 || Math.abs(Math.sin(aside)) < IN_PLANE) {
            double light = Math.copySign(theta, Math.cos(aside)) + 0.0;
            marks.add(new Mark("mirror", 0.0 - light));
            marks.add(new Mark("light", light));
        }
        Optional<SeenColor> purest = report.purest().map(ColorReport.Purest::colour);
        purest.filter(colour -> along && colour.view().thetaIDegrees() == theta)
                .ifPresent(colour -> marks.add(new Mark("purest", colour.view().thetaRDegrees())));
        marks.removeIf(mark -> Math.abs(mark.degrees()) > LARGEST);
        marks.sort(Comparator.comparingDouble(Mark::degrees));
        return marks;
    }

    private void named(Graphics2D graphics, List<Mark> marks, int stripTop) {
        graphics.setColor(INK);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        int free = 0;
        for (Mark mark : marks) {
            int x = x(mark.degrees());
            graphics.fill(
                    new Polygon(new int[] {x - 4, x + 4, x}, new int[] {stripTop - 8, stripTop - 8, stripTop - 1}, 3));
            int width = graphics.getFontMetrics().stringWidth(mark.name());
            int from = Math.max(free, x - width / 2);
            graphics.drawString(mark.name(), from, stripTop - 11);
            free = from + width + 8;
        }
    }

    private static final List<String> NAMES = List.of("mirror", "light", "purest");

    /** White, or yellow for the light, or a square for the purest, with a black border: seen on any colour. */
    private void dot(Graphics2D graphics, Mark mark, int y) {
        symbol(graphics, mark.name(), x(mark.degrees()), y);
    }

    private static void symbol(Graphics2D graphics, String name, int x, int y) {
        graphics.setColor(name.equals("light") ? new Color(0xF0E442) : Color.WHITE);
        if (name.equals("purest")) {
            graphics.fillRect(x - 4, y - 4, 8, 8);
            graphics.setColor(Color.BLACK);
            graphics.drawRect(x - 4, y - 4, 8, 8);
        } else {
            graphics.fillOval(x - 4, y - 4, 8, 8);
            graphics.setColor(Color.BLACK);
            graphics.drawOval(x - 4, y - 4, 8, 8);
        }
    }

    private void legend(Graphics2D graphics, int stripTop) {
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        int x = LEFT + 6;
        for (String name : NAMES) {
            symbol(graphics, name, x, stripTop - 10);
            graphics.setColor(INK);
            graphics.drawString(name, x + 8, stripTop - 6);
            x += 80;
        }
    }
}
