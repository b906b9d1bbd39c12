package sunbeam.app.cli;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.stat.descriptive.StatisticalSummary;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.HeatMap.ColorMap;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.evaluation.GratingPlane.FirstOrder;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix.ResponseGrid;
import sunbeam.precompute.evaluation.Ridge;
import sunbeam.precompute.evaluation.Ridge.Peaks;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** A patch's response in the plane of incidence, the period of its heights (docs/evaluation.md), and the first order's ridge, if any. */
record Evaluation(
        Patch patch,
        GratingPeriod period,
        ResponseMatrix response,
        Peaks peaks,
        Optional<Ridge> ridge,
        Optional<String> noRidge) {
    // Height of the plot relative to its width.
    private static final double RATIO = 0.72;
    // Lowest response of the color scale relative to the highest.
    private static final double SPAN = 1e-4;
    private static final String ANGLE = "angle to the viewer / degrees";
    // Okabe and Ito's colors, which PlotStyle has too, differ for color-blind readers; dashes differ without color.
    private static final int EQUATION = 0;
    private static final int FITTED = 0xE69F00;
    private static final int PEAKS = 0x56B4E9;
    private static final float[] FITTED_DASHES = {28, 14};
    private static final float[] PEAKS_DASHES = {14, 8};
    // Least distance between orders, in standard deviations of the window's spectrum: 1 % of the mirror order's
    // amplitude is left there, and more would shift the ridge by some percent.
    private static final double APART = 3;
    private static final int RIDGE_DIGITS = 5;
    private static final double NANOMETERS = 1e9;
    private static final double DEGREE_PARTS = 1e9;

    /** Parts of the picture. */
    enum Panel {
        RESPONSE
    }

    static Evaluation of(
            Patch patch,
            GratingPeriod period,
            FirstOrder order,
            ResponseMatrix response,
            CoherenceWindow window,
            Peaks peaks) {
        double orderPeriod = period.isSeen() ? period.period() : order.middle();
        boolean apart = 1 / orderPeriod >= APART * window.sigmaFrequency();
        Optional<Ridge> ridge = apart ? peaks.of(response, order, window.sigmaFrequency()) : Optional.empty();
        String noRidge = apart ? noneNear(order) : ordersRunTogether(patch, orderPeriod, window);
        return new Evaluation(
                patch, period, response, peaks, ridge, Optional.of(noRidge).filter(why -> ridge.isEmpty()));
    }

    private static String noneNear(FirstOrder order) {
        return Text.format(
                "the response has no ridge of periods from %s to %s at 3 --wavelengths or more within --angles; choose more of them",
                Lengths.rounded(order.shortest(), 3), Lengths.rounded(order.longest(), 3));
    }

    private static String ordersRunTogether(Patch patch, double period, CoherenceWindow window) {
        double needed = CoherenceWindow.ofCoherenceLength(1).sigmaFrequency() * APART * period;
        BigDecimal rounded = new BigDecimal(needed).round(new MathContext(2, RoundingMode.UP));
        String longer = Lengths.format(rounded.doubleValue());
        // No window is longer than a scan that does not repeat.
        boolean possible = patch.repetition() != Patch.Repetition.NONE || needed < patch.shorterSide();
        String option = OptionOrigin.INSTANCE.name(MethodSettings.COHERENCE_LENGTH);
        return Text.format(
                "light with a coherence length of %s sees a period of about %s %.1f times at once, too few to tell its orders apart; %s or more does",
                Lengths.rounded(window.coherenceLength(), 4),
                Lengths.rounded(period, 2),
                window.coherenceLength() / period,
                (possible ? option : "a scan whose shorter side is") + " " + longer);
    }

    static Verdict verdict(Patch patch, GratingPeriod period, GratingPlane plane) {
        return Verdict.of(patch, period, degrees(plane.thetaI(), DEGREE_PARTS), Math.toDegrees(plane.phiI()));
    }

    String light() {
        GratingPlane plane = response.grid().plane();
        return "light at " + Decimals.format(degrees(plane.thetaI(), 100)) + " degrees, azimuth "
                + Decimals.format(degrees(plane.azimuth(), 100)) + " degrees";
    }

    private static double degrees(double radians, double parts) {
        return Math.rint(parts * Math.toDegrees(radians)) / parts + 0.0;
    }

    List<String> lines(Average average, boolean explained) {
        List<String> lines = new ArrayList<>();
        lines.add(patch.name() + ", " + light());
        lines.add("period      " + period.describe());
        noRidge.ifPresent(why -> lines.add("ridge       left out: " + why));
        ridge.map(Ridge::statistics).ifPresent(periods -> {
            String area =
                    average == Average.ENSEMBLE ? "the mean over all positions of the window" : "one coherence area";
            // If the period is uncertain, two digits are enough.
            lines.add(Text.format(
                    "%-11s %s, the brightest of %s over %d wavelengths, order %d: where light goes, not how well the period is known",
                    peaks == Peaks.RIDGE ? "ridge" : "maxima",
                    Lengths.rounded(periods.getMean(), period.isSure() ? RIDGE_DIGITS : 2),
                    area,
                    periods.getN(),
                    ridge.get().order()));
            if (explained) {
                lines.add(Text.format(
                        "            mean %.2f nm, variance %.2g nm2, standard error %.1g nm over the wavelengths",
                        periods.getMean() * NANOMETERS,
                        periods.getVariance() * NANOMETERS * NANOMETERS,
                        standardError(periods) * NANOMETERS));
            }
        });
        return lines;
    }

    private static double standardError(StatisticalSummary periods) {
        return Math.sqrt(periods.getVariance() / periods.getN());
    }

    Map<String, Object> tree() {
        ResponseGrid grid = response.grid();
        Map<String, Object> tree = JsonOption.fields(patch, period, verdict(patch, period, grid.plane()));
        tree.put("theta_i_deg", degrees(grid.plane().thetaI(), DEGREE_PARTS));
        tree.put("phi_i_deg", degrees(grid.plane().phiI(), DEGREE_PARTS));
        tree.put("azimuth_deg", degrees(grid.plane().azimuth(), DEGREE_PARTS));
        tree.put("angles_deg", range(grid.angles(), Math.toDegrees(1)));
        tree.put("wavelengths_m", range(grid.wavelengths(), 1));
        tree.put("peaks", ValueKind.name(peaks));
        tree.put("ridge_left_out", noRidge.orElse(null));
        ridge.ifPresent(found -> {
            tree.put("order", found.order());
            tree.put(peaks == Peaks.RIDGE ? "peaks_interpolated" : "peaks_at_maxima", tree(found.statistics()));
        });
        return tree;
    }

    private static Map<String, Object> tree(StatisticalSummary periods) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("mean_m", periods.getMean());
        tree.put("variance_m2", periods.getVariance());
        tree.put("standard_error_m", standardError(periods));
        tree.put("wavelengths", periods.getN());
        return tree;
    }

    private static Map<String, Object> range(double[] values, double unit) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("first", values[0] * unit);
        tree.put("last", values[values.length - 1] * unit);
        tree.put("count", values.length);
        return tree;
    }

    /** Returns a row for each wavelength in nm and a column for each angle, whose heading is the angle in degrees. */
    StreamContent csv() {
        ResponseGrid grid = response.grid();
        List<String> header = new ArrayList<>(List.of("wavelength_nm"));
        Arrays.stream(grid.angles()).forEach(angle -> header.add(Text.format("%.6f", Math.toDegrees(angle))));
        return CsvWriter.numbers(header, grid.wavelengths().length, row -> {
            DoubleStream wavelength = DoubleStream.of(grid.wavelengths()[row] * NANOMETERS);
            return DoubleStream.concat(wavelength, Arrays.stream(response.values()[row]))
                    .toArray();
        });
    }

    /** Plot as in the thesis's figures 4.9 to 4.11: the response, its peaks, and curves of the grating equation. */
    Drawing plot(String method, int width, boolean alone) {
        Drawing picture = picture(method + "; " + light(), width, (int) (RATIO * width));
        if (alone) {
            return picture;
        }
        return new Sheet(width)
                .heading(patch.name() + ": "
                        + verdict(patch, period, response.grid().plane()).sentence())
                .row(picture)
                .draw();
    }

    private Drawing picture(String title, int width, int height) {
        ResponseGrid grid = response.grid();
        double[][] values = response.values();
        double[] wavelengths = map(grid.wavelengths(), meters -> meters * NANOMETERS);
        double[] angles = map(grid.angles(), Math::toDegrees);
        if (wavelengths.length == 1) {
            String lit = Text.format("%s, %.4g nm", title, wavelengths[0]);
            return Plot.linear(lit, ANGLE, "relative radiance", width, height)
                    .line("response", angles, values[0])
                    .draw();
        }
        double largest =
                Arrays.stream(values).flatMapToDouble(Arrays::stream).max().orElse(0);
        double high = largest > 0 ? largest : 1;
        double[][] rows = new Array2DRowRealMatrix(values, false).transpose().getData();
        double[] x = HeatMap.Values.around(wavelengths);
        double[] y = HeatMap.Values.around(angles);
        HeatMap.Colors colors =
                new HeatMap.Colors("relative radiance", SPAN * high, high, Plot.Scale.LOGARITHMIC, ColorMap.VIRIDIS);
        HeatMap map = new HeatMap(
                new HeatMap.Frame(title, "wavelength / nm", ANGLE, width, height, false),
                new HeatMap.Values(rows, x, y, colors, HeatMap.Reduction.LARGEST));
        if (period.isSure()) {
            boolean towardsNormal = !Double.isNaN(grid.plane().thetaR(-grid.wavelengths()[0] / period.period()));
            int order = ridge.map(Ridge::order).orElse(towardsNormal ? 1 : -1);
            map.interval(
                    "period " + period.interval().replace("95 % interval", "95 % (dotted)"),
                    wavelengths,
                    equation(grid, order, period.period()),
                    equation(grid, order, period.low()),
                    equation(grid, order, period.high()),
                    EQUATION);
        }
        ridge.ifPresent(found -> {
            double mean = found.statistics().getMean();
            double[] fitted = equation(grid, found.order(), mean);
            map.curve("grating equation for the peaks' mean", wavelengths, fitted, FITTED, FITTED_DASHES);
            String name = Text.format("peaks: %s (mean %.1f nm)", ValueKind.name(peaks), mean * NANOMETERS);
            double[] ridgeWavelengths = map(found.wavelengths(), meters -> meters * NANOMETERS);
            map.curve(name, ridgeWavelengths, map(found.angles(), Math::toDegrees), PEAKS, PEAKS_DASHES);
        });
        return map.draw();
    }

    private static double[] equation(ResponseGrid grid, int order, double period) {
        return map(grid.wavelengths(), wavelength -> Math.toDegrees(grid.plane().thetaR(-order * wavelength / period)));
    }

    private static double[] map(double[] values, DoubleUnaryOperator function) {
        return Arrays.stream(values).map(function).toArray();
    }
}
