package sunbeam.app.commands.color;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.FittedNames;
import sunbeam.app.files.plot.Plot;
import sunbeam.precompute.color.Chromaticity;
import sunbeam.precompute.color.CieTable;

/** The picture: a pair of strips for each surface, the chromaticities and the spectra; a surface has one color in all. */
final class ColorSheet {
    private static final int WIDTH = 1280;
    private static final int LEFT = 40;
    private static final int PLOT_HEIGHT = 560;
    private static final int CAPTION = 48;
    private static final double TICK = 0.1;
    private static final Color INK = new Color(0x222222);

    private final List<ColorReport> reports;
    private final List<String> names;
    private final Map<String, Object> settings;
    private final CieTable cie;

    /** @param settings as in the files' text */
    ColorSheet(List<ColorReport> reports, Map<String, Object> settings, CieTable cie) {
        this.reports = reports;
        this.names = FittedNames.of(
                reports.stream().map(report -> report.patch().name()).toList(),
                StripPanel.TITLE_FONT,
                StripPanel.WIDEST_NAME);
        this.settings = settings;
        this.cie = cie;
    }

    BufferedImage draw() {
        List<StripPanel> panels = IntStream.range(0, reports.size())
                .mapToObj(i -> new StripPanel(reports.get(i), names.get(i), i, WIDTH))
                .toList();
        int top = panels.stream().mapToInt(StripPanel::height).sum();
        BufferedImage image = new BufferedImage(WIDTH, top + PLOT_HEIGHT + CAPTION, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, WIDTH, image.getHeight());
        int y = 0;
        for (StripPanel panel : panels) {
            panel.draw(graphics, y);
            y += panel.height();
        }
        graphics.drawImage(chromaticities(), 0, y, null);
        graphics.drawImage(spectra(), WIDTH / 2, y, null);
        caption(graphics, y + PLOT_HEIGHT);
        graphics.dispose();
        return image;
    }

    private void caption(Graphics2D graphics, int top) {
        graphics.setColor(INK);
        Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
        graphics.setFont(font);
        // Each surface's own coherence length stands in its title.
        String options = Arrays.stream(settings.get("options").toString().split(", ", -1))
                .filter(option -> !option.startsWith("coherence length"))
                .collect(Collectors.joining(", "));
        String exposed = String.format(Locale.ROOT, "one exposure for all: %.4g; ", (Double) settings.get("exposure"));
        String method = "; method " + settings.get("method") + ", " + options;
        double room = WIDTH - 2 * LEFT - FittedNames.width(exposed + method, font);
        String index = FittedNames.of("refractive index " + settings.get("index"), font, room);
        graphics.drawString(exposed + index + method, LEFT, top + 14);
        graphics.drawString(
                "angles of the view to the normal, negative on the side away from the azimuth", LEFT, top + 34);
    }

    /** The locus of spectral light, white, and each surface's colors along its plane of most color. */
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
        plot.legendBelow().equalScales(TICK).outline("spectral colors", xs(locus), ys(locus));
        for (int i = 0; i < reports.size(); i++) {
            List<Chromaticity> seen = reports.get(i).colors().stream()
                    .filter(color -> color.view().along() && color.xyz()[1] > 0)
                    .map(SeenColor::chromaticity)
                    .toList();
            if (!seen.isEmpty()) {
                plot.points(names.get(i), xs(seen), ys(seen), new Plot.Look(i, 0));
            }
        }
        List<Chromaticity> white = List.of(Chromaticity.WHITE);
        plot.rings("white (D65)", xs(white), ys(white));
        List<Chromaticity> purest = reports.stream()
                .flatMap(report -> report.purest().stream())
                .map(SeenColor::chromaticity)
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

    private BufferedImage spectra() {
        List<ColorReport.SeenSpectrum> all =
                reports.stream().flatMap(report -> report.spectra().stream()).toList();
        // A single line has no legend.
        String angle =
                all.size() == 1 ? " at " + StripPanel.angle(all.get(0).view().thetaRDegrees()) : "";
        String light = StripPanel.angle(all.get(0).view().thetaIDegrees());
        Plot plot = new Plot(new Plot.Frame(
                "Spectrum along" + angle + ", light at " + light,
                Plot.Axis.linear("wavelength / nm"),
                Plot.Axis.linear("relative radiance, share of its maximum"),
                WIDTH / 2,
                PLOT_HEIGHT));
        plot.legendBelow();
        for (int i = 0; i < reports.size(); i++) {
            List<ColorReport.SeenSpectrum> spectra = reports.get(i).spectra();
            for (int j = 0; j < spectra.size(); j++) {
                add(plot, names.get(i), spectra.get(j), new Plot.Look(i, j));
            }
        }
        return plot.draw();
    }

    private static void add(Plot plot, String name, ColorReport.SeenSpectrum spectrum, Plot.Look look) {
        double[] nanometres = new double[spectrum.wavelengths().length];
        double[] shares = new double[nanometres.length];
        double largest = Math.max(
                Double.MIN_NORMAL, Arrays.stream(spectrum.radiances()).max().orElseThrow());
        for (int i = 0; i < nanometres.length; i++) {
            nanometres[i] = spectrum.wavelengths()[i] * 1e9;
            shares[i] = spectrum.radiances()[i] / largest;
        }
        plot.line(name + " at " + StripPanel.angle(spectrum.view().thetaRDegrees()), nanometres, shares, look);
    }
}
