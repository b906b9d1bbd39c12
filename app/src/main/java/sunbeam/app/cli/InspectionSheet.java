package sunbeam.app.cli;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.app.cli.InspectionSheet.Panel;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.HeatMap.Colors;
import sunbeam.app.files.plot.HeatMap.Frame;
import sunbeam.app.files.plot.HeatMap.Values;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Picture of an inspection: text, and four panels.
 *
 * @param lines text, of which the first, the verdict's sentence, is the heading
 * @param width pixels
 * @param panel the only panel to draw, if not all
 */
record InspectionSheet(Inspection inspection, List<String> lines, int width, Optional<Panel> panel) {
    /** Parts of the picture. */
    enum Panel {
        HEIGHTS,
        SPECTRUM,
        HISTOGRAM,
        PROFILE
    }

    private static final int LABELS = 130;
    // Heights of maps and of plots relative to their widths.
    private static final double MAP_RATIO = 0.9;
    private static final double PLOT_RATIO = 0.69;
    private static final int HISTOGRAM_BINS = 100;
    // Least width of a bin, meters, where all heights are equal.
    private static final double LEAST_STEP = 1e-12;
    // Share of the lowest and of the highest heights that the gray scale leaves out.
    private static final double DUST = 0.001;
    private static final int PROFILE_PERIODS = 12;
    private static final double MICROMETERS = 1e6;
    private static final double NANOMETERS = 1e9;
    // Lowest power of the color scale relative to the highest.
    private static final double SPAN = 1e-7;
    // Least range of frequencies that is drawn, 1/m: |(u, v)| = 2 at 780 nm.
    private static final double LEAST_SHOWN = 2 / CieTable.MAXIMUM_WAVELENGTH;
    // Least range of frequencies that is drawn, relative to that of the period.
    private static final double SHOWN_PER_PERIOD = 1.5;

    private HeightMap map() {
        return inspection.patch().scan();
    }

    private Sheet text() {
        Sheet sheet = new Sheet(width)
                .heading(inspection.patch().name() + ": " + inspection.verdict().sentence());
        lines.stream().skip(1).forEach(line -> sheet.labeled(line, LABELS));
        return sheet;
    }

    /** Returns x, y, width and height of the heights and their spectrum in the picture, pixels. */
    List<Integer> thumbnail() {
        int across = new Sheet(width).plotWidth();
        int below = across == width ? 2 : 1;
        return panel.map(drawn -> List.of(0, 0, width, height(drawn, width)))
                .orElseGet(() -> List.of(0, text().height(), width, below * height(Panel.HEIGHTS, across)));
    }

    private static int height(Panel drawn, int across) {
        return (int) (across * (drawn == Panel.HEIGHTS || drawn == Panel.SPECTRUM ? MAP_RATIO : PLOT_RATIO));
    }

    Drawing draw() {
        return panel.map(this::drawing)
                .orElseGet(() -> text().row(drawing(Panel.HEIGHTS), drawing(Panel.SPECTRUM))
                        .row(drawing(Panel.HISTOGRAM), drawing(Panel.PROFILE))
                        .draw());
    }

    private Drawing drawing(Panel drawn) {
        int across = panel.isPresent() ? width : new Sheet(width).plotWidth();
        int high = height(drawn, across);
        return switch (drawn) {
            case HEIGHTS -> heights(across, high);
            case SPECTRUM -> spectrum(across, high);
            case HISTOGRAM ->
                curve(
                        Plot.linear("Share of the surface per nm", "height / nm", "", across, high)
                                .fromZero(),
                        histogram());
            case PROFILE -> {
                String title = Text.format("Profile through the center, %.1f\u00b0", rounded(direction()));
                yield curve(Plot.linear(title, "position / um", "height / nm", across, high), profile());
            }
        };
    }

    private static Drawing curve(Plot plot, double[][] values) {
        return plot.line("", values[0], values[1]).draw();
    }

    /** Returns the values of the only panel in SI units; those of the heights are the scan itself. */
    Optional<StreamContent> csv() {
        return panel.flatMap(drawn -> switch (drawn) {
            case HEIGHTS -> Optional.<StreamContent>empty();
            case SPECTRUM -> Optional.of(densities());
            case HISTOGRAM -> Optional.of(table("height_m", "share_per_m", histogram(), NANOMETERS, 1 / NANOMETERS));
            case PROFILE -> Optional.of(table("position_m", "height_m", profile(), MICROMETERS, NANOMETERS));
        });
    }

    private static StreamContent table(String x, String y, double[][] values, double unitX, double unitY) {
        return CsvWriter.numbers(
                List.of(x, y), values[0].length, i -> new double[] {values[0][i] / unitX, values[1][i] / unitY});
    }

    private StreamContent densities() {
        HeightSpectrum spectrum = inspection.spectrum();
        int columns = 2 * reachX() + 1;
        List<String> names =
                List.of("frequency_x_per_m", "frequency_y_per_m", isProfile() ? "density_m3" : "density_m4");
        return CsvWriter.numbers(names, columns * (2 * reachY() + 1), i -> {
            int jx = i % columns - reachX();
            int jy = i / columns - reachY();
            return new double[] {jx / spectrum.width(), jy / spectrum.height(), density(jx, jy)};
        });
    }

    private boolean isProfile() {
        return map().columns() == 1 || map().rows() == 1;
    }

    private int reachX() {
        return (int) Math.min(
                inspection.spectrum().bandX().last(),
                Math.ceil(shown() * inspection.spectrum().width()));
    }

    private int reachY() {
        return (int) Math.min(
                inspection.spectrum().bandY().last(),
                Math.ceil(shown() * inspection.spectrum().height()));
    }

    private double shown() {
        return Math.max(
                LEAST_SHOWN, SHOWN_PER_PERIOD * inspection.period().wave().length());
    }

    /** Returns the power of a bin by its area, m^4, or of a profile by its length, m^3. */
    private double density(int jx, int jy) {
        HeightSpectrum spectrum = inspection.spectrum();
        double x = map().columns() == 1 ? 1 : spectrum.width();
        double y = map().rows() == 1 ? 1 : spectrum.height();
        return spectrum.at(jx, jy) * x * y;
    }

    private Drawing heights(int across, int tall) {
        double[][] rows = new double[map().rows()][map().columns()];
        for (int row = 0; row < map().rows(); row++) {
            int mapRow = map().rows() - 1 - row;
            Arrays.setAll(rows[row], column -> map().at(column, mapRow) * NANOMETERS);
        }
        // Leaves out the lowest and highest 0.1 %: with a grain of dust in it, all else would be one gray.
        double[] heights = map().heights();
        double low = Quantiles.of(heights, DUST) * NANOMETERS;
        double high = Math.max(Quantiles.of(heights, 1 - DUST) * NANOMETERS, low + 1e-3);
        Colors colors = new Colors("", low, high, Plot.Scale.LINEAR, HeatMap.ColorMap.GRAY);
        double width = map().width() * MICROMETERS;
        double bar = Plot.round(0.25 * width);
        double[] x = {0, width};
        double[] y = {0, map().height() * MICROMETERS};
        return new HeatMap(
                        new Frame("Height / nm", "x / um", "y / um", across, tall, true),
                        new Values(rows, x, y, colors, HeatMap.Reduction.MIDDLE))
                .scaleBar(Lengths.format(bar / MICROMETERS), bar)
                .draw();
    }

    private Drawing spectrum(int across, int tall) {
        HeightSpectrum spectrum = inspection.spectrum();
        GratingPeriod period = inspection.period();
        int reachX = reachX();
        int reachY = reachY();
        double unit = NANOMETERS * NANOMETERS * (isProfile() ? MICROMETERS : NANOMETERS * NANOMETERS);
        double[][] rows = new double[2 * reachY + 1][2 * reachX + 1];
        for (int row = 0; row < rows.length; row++) {
            int jy = row - reachY;
            Arrays.setAll(rows[row], column -> unit * density(column - reachX, jy));
        }
        double largest =
                Arrays.stream(rows).flatMapToDouble(Arrays::stream).max().orElse(0);
        double high = largest > 0 ? largest : 1;
        Colors colors = new Colors("", SPAN * high, high, Plot.Scale.LOGARITHMIC, HeatMap.ColorMap.VIRIDIS);
        double halfX = (reachX + 0.5) / spectrum.width() / MICROMETERS;
        double halfY = (reachY + 0.5) / spectrum.height() / MICROMETERS;
        double[] x = {-halfX, halfX};
        double[] y = {-halfY, halfY};
        String title = "Power spectral density / " + (isProfile() ? "nm^2 um" : "nm^4");
        String axis = "periods per um along ";
        HeatMap picture = new HeatMap(
                new Frame(title, axis + "x", axis + "y", across, tall, true),
                new Values(rows, x, y, colors, HeatMap.Reduction.LARGEST));
        if (period.hasWave()) {
            period.waves()
                    .forEach(wave -> picture.mark(
                            Lengths.rounded(wave.period(), 3), wave.x() / MICROMETERS, wave.y() / MICROMETERS));
        }
        return picture.draw();
    }

    /** Returns heights in nm, and the share of the surface per nm at each. */
    private double[][] histogram() {
        HeightMap measured = inspection.patch().measured();
        double low = measured.minimum();
        double step = Math.max(measured.relief() / (HISTOGRAM_BINS - 1), LEAST_STEP);
        double[] shares = new double[HISTOGRAM_BINS];
        double[] heights = inspection.patch().measuredHeights();
        double one = 1 / (step * NANOMETERS * heights.length);
        // Heights count in two neighboring bins, by distance, so that the levels of an 8-bit scan are no comb.
        for (double height : heights) {
            double place = (height - low) / step;
            int bin = Math.min(HISTOGRAM_BINS - 2, (int) place);
            shares[bin] += one * (1 - (place - bin));
            shares[bin + 1] += one * (place - bin);
        }
        double[] centers = IntStream.range(0, HISTOGRAM_BINS)
                .mapToDouble(bin -> (low + bin * step) * NANOMETERS)
                .toArray();
        return new double[][] {centers, shares};
    }

    private double direction() {
        GratingPeriod period = inspection.period();
        return period.hasWave() ? period.azimuth() : map().columns() == 1 ? 0.5 * Math.PI : 0;
    }

    private static double rounded(double radians) {
        return Math.rint(10 * Math.toDegrees(radians)) / 10 + 0.0;
    }

    /**
     * Samples a line through the center at the finer of both pitches, as far as the patch reaches; micrometers and nanometers, NaN where
     * samples are filled.
     */
    private double[][] profile() {
        GratingPeriod period = inspection.period();
        double longest = period.hasWave() ? PROFILE_PERIODS * period.period() : Double.POSITIVE_INFINITY;
        double pitch = Math.min(map().pitchX(), map().pitchY());
        double cosine = Math.cos(direction());
        double sine = Math.sin(direction());
        int half = 0;
        while (half * pitch < 0.5 * longest && isInside((half + 1) * pitch * cosine, (half + 1) * pitch * sine)) {
            half++;
        }
        double[] positions = new double[2 * half + 1];
        double[] heights = new double[positions.length];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = i * pitch * MICROMETERS;
            heights[i] = at((i - half) * pitch * cosine, (i - half) * pitch * sine) * NANOMETERS;
        }
        return new double[][] {positions, heights};
    }

    private boolean isInside(double x, double y) {
        return Math.abs(x) <= 0.5 * (map().columns() - 1) * map().pitchX()
                && Math.abs(y) <= 0.5 * (map().rows() - 1) * map().pitchY();
    }

    private double at(double x, double y) {
        return inspection.patch().known().at((int) Math.floor(0.5 * map().columns() + x / map().pitchX() - 1e-9), (int)
                Math.floor(0.5 * map().rows() - y / map().pitchY() - 1e-9));
    }
}
