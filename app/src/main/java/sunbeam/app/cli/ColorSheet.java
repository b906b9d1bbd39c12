package sunbeam.app.cli;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.app.cli.ColorReport.ViewColor;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.PlotStyle;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Picture of the result: two strips of colors for each surface, a chart of chromaticities and one of spectra. */
final class ColorSheet {
    private static final int LEFT = 250;
    private static final int RIGHT = 40;
    private static final int STRIP = 84;
    private static final int GAP = 14;
    private static final int LABELS = 52;
    // Height of a plot relative to its width.
    private static final double RATIO = 1.02;
    // The same of spectra below another plot: the page of one surface fits a column of print, 225 mm high.
    private static final double LOW_RATIO = 0.7;
    /** Largest width of a surface's name, pixels: some 32 letters. */
    private static final int WIDEST_NAME = 500;
    // Sine of the largest azimuth between the light and a strip's plane at which the light is marked in the strip.
    private static final double IN_PLANE = Math.sin(Math.toRadians(1));
    private static final double TICK = 0.2;
    // Largest step between labels, as a share of the range of angles.
    private static final double TICKS = 0.15;
    private static final Color LIGHT = new Color(0xF0E442);

    private final List<ColorReport> reports;
    private final List<String> names;
    private final Map<String, Object> settings;
    private final CieTable cie;
    private final int width;
    private final Optional<Panel> panel;
    private final double first;
    private final double last;

    /** Parts of the picture. */
    enum Panel {
        STRIPS,
        CHROMATICITY,
        SPECTRUM
    }

    /**
     * @param width pixels
     * @param panel the only panel to draw, if not all
     */
    ColorSheet(
            List<ColorReport> reports, Map<String, Object> settings, CieTable cie, int width, Optional<Panel> panel) {
        this.width = width;
        this.panel = panel;
        this.reports = reports;
        this.names = Sheet.fittedNames(
                reports.stream().map(report -> report.patch().name()).toList(), Sheet.FONT, WIDEST_NAME);
        this.settings = settings;
        this.cie = cie;
        this.first = angleOf(0);
        this.last = angleOf(reports.get(0).colors().size() / 2 - 1);
    }

    private Sheet texts(Sheet sheet, int number) {
        ColorReport report = reports.get(number);
        sheet.heading(names.get(number) + ": " + report.verdict().sentence()).text(title(report), Sheet.FONT);
        report.patch().gaps().ifPresent(gaps -> sheet.text(gaps, Sheet.FONT));
        return sheet;
    }

    /** Returns x, y, width and height of the first surface's strips in the picture, pixels. */
    List<Integer> thumbnail() {
        if (panel.isPresent() && panel.get() != Panel.STRIPS) {
            return List.of(0, 0, width, draw().height());
        }
        return List.of(LEFT, texts(new Sheet(width), 0).height() + GAP, width - LEFT - RIGHT, 2 * STRIP + GAP + LABELS);
    }

    Drawing draw() {
        return panel.map(drawn -> switch (drawn) {
                    case STRIPS -> strips().draw();
                    case CHROMATICITY -> chromaticities();
                    case SPECTRUM -> spectra();
                })
                .orElseGet(() -> strips().row(chromaticities(), spectra())
                        .text(caption(), Sheet.FONT)
                        .text("angles of the view to the normal, positive towards the azimuth", Sheet.FONT)
                        .draw());
    }

    /** Returns the spectra that are drawn: a column of relative radiances for each surface. */
    StreamContent spectraCsv() {
        List<String> columns = new ArrayList<>(List.of("wavelength_nm"));
        IntStream.rangeClosed(1, reports.size()).forEach(number -> columns.add("radiance_" + number));
        double[] nanometers = ColorReport.Spectrum.nanometers();
        return CsvWriter.numbers(
                columns,
                nanometers.length,
                i -> DoubleStream.concat(
                                DoubleStream.of(nanometers[i]),
                                reports.stream()
                                        .mapToDouble(report -> report.spectrum().radiances()[i]))
                        .toArray());
    }

    private Sheet strips() {
        Sheet sheet = new Sheet(width);
        for (int i = 0; i < reports.size(); i++) {
            ColorReport report = reports.get(i);
            Color mark = PlotStyle.color(i);
            texts(sheet, i);
            for (boolean along : new boolean[] {true, false}) {
                sheet.part(GAP + STRIP + LABELS, graphics -> strip(graphics, report, along, mark));
            }
        }
        return sheet;
    }

    private int plotWidth() {
        return panel.isPresent() ? width : new Sheet(width).plotWidth();
    }

    static String title(ColorReport report) {
        String purest = report.purest()
                .map(color -> "; purest (square) " + color.hex() + " at "
                        + angle(color.view().thetaRDegrees()) + " "
                        + color.view().strip())
                .orElse("");
        double[] azimuths = report.colors().stream()
                .mapToDouble(color -> color.view().phiIDegrees())
                .distinct()
                .toArray();
        String light = azimuths.length == 1 ? angle(azimuths[0]) : "that of the strip";
        return Text.format(
                "light (yellow) at %s, azimuth %s; mirror direction (white)%s; coherence length %s",
                angle(theta(report)), light, purest, Lengths.rounded(report.coherenceLength(), 3));
    }

    private static double theta(ColorReport report) {
        return report.colors().get(0).view().thetaIDegrees();
    }

    private static String angle(double degrees) {
        return Decimals.format(Math.round(degrees * 10) / 10.0 + 0.0) + "\u00b0";
    }

    private int x(double degrees) {
        double inside = Math.max(first, Math.min(last, degrees));
        return LEFT + (int) Math.round((inside - first) * (width - LEFT - RIGHT) / (last - first));
    }

    private double angleOf(int number) {
        return reports.get(0).colors().get(number).view().thetaRDegrees();
    }

    private void strip(Graphics2D graphics, ColorReport report, boolean along, Color mark) {
        List<ViewColor> colors = report.colors().stream()
                .filter(color -> color.view().along() == along)
                .toList();
        int middle = GAP + STRIP / 2;
        graphics.setColor(mark);
        graphics.fillRect(LEFT - 22, GAP, 14, STRIP);
        double step = angleOf(1) - first;
        for (ViewColor color : colors) {
            int from = x(color.view().thetaRDegrees() - step / 2);
            int to = x(color.view().thetaRDegrees() + step / 2);
            graphics.setColor(new Color(color.rgb()));
            // One pixel over the next color, lest a viewer of vectors shows the paper between them.
            graphics.fillRect(from, GAP, Math.min(to + 1, x(last)) - from, STRIP);
        }
        marks(graphics, report, colors.get(0).view(), middle);
        graphics.setColor(PlotStyle.INK);
        graphics.drawString(colors.get(0).view().strip(), 14, middle - 4);
        graphics.drawString(
                PlotStyle.typeset(
                        "azimuth " + angle(Math.rint(colors.get(0).view().phiDegrees()))),
                14,
                middle + 32);
        double ticks = Plot.round(TICKS * (last - first));
        for (double degrees = Math.ceil(first / ticks) * ticks; degrees <= last; degrees += ticks) {
            int x = x(degrees);
            graphics.drawLine(x, GAP + STRIP, x, GAP + STRIP + 8);
            String label = PlotStyle.typeset(angle(degrees));
            graphics.drawString(label, x - graphics.getFontMetrics().stringWidth(label) / 2, GAP + STRIP + 40);
        }
    }

    /** Marks light, mirror direction and purest color in a strip, with a black border that is seen on any color. */
    private void marks(Graphics2D graphics, ColorReport report, ViewColor.View strip, int y) {
        double theta = strip.thetaIDegrees();
        double aside = Math.toRadians(strip.phiIDegrees() - strip.phiDegrees());
        if (theta == 0 || Math.abs(Math.sin(aside)) < IN_PLANE) {
            double light = Math.copySign(theta, Math.cos(aside));
            mark(graphics, new Ellipse2D.Double(x(-light) - 10, y - 10, 20, 20), Color.WHITE);
            mark(graphics, new Ellipse2D.Double(x(light) - 6, y - 6, 12, 12), LIGHT);
        }
        report.purest().filter(color -> color.view().along() == strip.along()).ifPresent(color -> {
            int x = x(color.view().thetaRDegrees());
            graphics.setColor(Color.WHITE);
            graphics.drawRect(x - 10, y - 10, 20, 20);
            graphics.setColor(Color.BLACK);
            graphics.drawRect(x - 12, y - 12, 24, 24);
        });
    }

    private static void mark(Graphics2D graphics, Shape shape, Color color) {
        graphics.setColor(color);
        graphics.fill(shape);
        graphics.setColor(Color.BLACK);
        graphics.draw(shape);
    }

    private String caption() {
        // The coherence length may differ by surface, so it is in each surface's title.
        String options = Arrays.stream(settings.get("options").toString().split(", ", -1))
                .filter(option -> !option.startsWith("coherence length"))
                .collect(Collectors.joining(", "));
        return Text.format(
                "exposure %s%s; refractive index %s; method %s, %s",
                Decimals.rounded((Double) settings.get("exposure"), 3),
                reports.size() > 1 ? ", the same for all" : "",
                settings.get("index"),
                settings.get("method"),
                options);
    }

    private Drawing chromaticities() {
        // Closed by the line of purples.
        List<Chromaticity> locus = IntStream.concat(
                        IntStream.rangeClosed(CieTable.FIRST_NANOMETER, 700), IntStream.of(CieTable.FIRST_NANOMETER))
                .mapToObj(nanometer -> Chromaticity.ofWavelength(cie, nanometer * 1e-9))
                .toList();
        Plot plot = Plot.linear("Chromaticity" + ofOne(ViewColor.View::strip), "x (CIE 1931)", "y", plotWidth(), (int)
                (RATIO * plotWidth()));
        plot.equalScales(TICK).outline("spectral colors", xs(locus), ys(locus));
        for (int i = 0; i < reports.size(); i++) {
            ColorReport report = reports.get(i);
            List<Chromaticity> seen = report.colors().stream()
                    .filter(color ->
                            color.view().along() == report.spectrum().view().along() && color.xyz()[1] > 0)
                    .map(ViewColor::chromaticity)
                    .toList();
            if (!seen.isEmpty()) {
                plot.points(names.get(i), xs(seen), ys(seen), i);
            }
        }
        List<Chromaticity> white = List.of(Chromaticity.of(cie.white()));
        plot.rings("white", xs(white), ys(white));
        List<Chromaticity> purest = reports.stream()
                .flatMap(report -> report.purest().stream())
                .map(ViewColor::chromaticity)
                .toList();
        if (!purest.isEmpty()) {
            plot.rings("purest", xs(purest), ys(purest));
        }
        return plot.draw();
    }

    private static double[] xs(List<Chromaticity> points) {
        return points.stream().mapToDouble(Chromaticity::x).toArray();
    }

    private static double[] ys(List<Chromaticity> points) {
        return points.stream().mapToDouble(Chromaticity::y).toArray();
    }

    private Drawing spectra() {
        String title = "Radiance" + ofOne(ColorSheet::place);
        String radiance = "share of the maximum";
        double ratio = panel.isEmpty() && plotWidth() == width ? LOW_RATIO : RATIO;
        Plot plot = Plot.linear(title, "wavelength / nm", radiance, plotWidth(), (int) (ratio * plotWidth()));
        plot.fromZero();
        for (int i = 0; i < reports.size(); i++) {
            ColorReport.Spectrum spectrum = reports.get(i).spectrum();
            double most = Arrays.stream(spectrum.radiances()).reduce(Double.MIN_NORMAL, Math::max);
            double[] shares = Arrays.stream(spectrum.radiances())
                    .map(value -> value / most)
                    .toArray();
            plot.line(names.get(i) + " " + place(spectrum.view()), ColorReport.Spectrum.nanometers(), shares, i);
        }
        return plot.draw();
    }

    private String ofOne(Function<ViewColor.View, String> words) {
        return reports.size() == 1 ? " " + words.apply(reports.get(0).spectrum().view()) : "";
    }

    private static String place(ViewColor.View view) {
        return view.strip() + " at " + angle(view.thetaRDegrees());
    }
}
