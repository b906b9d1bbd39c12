package sunbeam.app.cli.evaluate;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.HeatMap.ColorMap;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.evaluation.ResponseMatrix.ResponseGrid;
import sunbeam.precompute.evaluation.Ridge;
import sunbeam.precompute.text.Text;

/**
 * Plot as in the thesis's figures 4.9 to 4.11: the response, its brightest angles, and the grating equation for the period of the heights,
 * for both ends of its interval, and for the mean period of the brightest angles.
 */
final class ResponsePlot {
    private static final int WIDTH = 1100;
    private static final int HEIGHT = 800;
    // Lowest response of the color scale relative to the highest.
    private static final double SPAN = 1e-4;
    private static final int PEAKS = 0xFF3020;
    private static final int FITTED = 0x40A0FF;
    private static final int EQUATION = 0xE868E8;

    private ResponsePlot() {}

    static BufferedImage draw(Evaluation evaluation, String method) {
        return new Sheet(WIDTH)
                .heading(evaluation.patch().name() + ": " + evaluation.verdict().sentence())
                .row(response(evaluation, method + "; " + evaluation.light()))
                .draw();
    }

    private static BufferedImage response(Evaluation evaluation, String title) {
        ResponseGrid grid = evaluation.response().grid();
        double[][] values = evaluation.response().values();
        double largest =
                Arrays.stream(values).flatMapToDouble(Arrays::stream).max().orElseThrow();
        double high = largest > 0 ? largest : 1;
        double[][] rows = new double[grid.angles().length][values.length];
        for (int row = 0; row < rows.length; row++) {
            for (int column = 0; column < values.length; column++) {
                rows[row][column] = values[column][row];
            }
        }
        double[] wavelengths = nanometers(grid.wavelengths());
        if (wavelengths.length == 1) {
            return profile(evaluation, title, wavelengths[0]);
        }
        HeatMap map = new HeatMap(
                new HeatMap.Frame(
                        title, "wavelength / nm", "angle to the viewer theta_r / degrees", WIDTH, HEIGHT, false),
                new HeatMap.Values(
                        rows,
                        HeatMap.Values.around(wavelengths),
                        HeatMap.Values.around(degrees(grid.angles(), angle -> angle)),
                        new HeatMap.Colors(
                                "relative radiance rho", SPAN * high, high, Plot.Scale.LOGARITHMIC, ColorMap.VIRIDIS),
                        HeatMap.Reduction.LARGEST));
        if (evaluation.period().isSure()) {
            drawEquation(evaluation.period(), evaluation, map);
        }
        evaluation.ridge().ifPresent(ridge -> {
            drawFitted(ridge, grid, map);
            drawPeaks(ridge, map);
        });
        return map.draw();
    }

    private static BufferedImage profile(Evaluation evaluation, String title, double nanometers) {
        String lit = Text.format("%s, %.4g nm", title, nanometers);
        return Plot.linear(lit, "angle to the viewer theta_r / degrees", "relative radiance rho", WIDTH, HEIGHT)
                .line(
                        "response",
                        degrees(evaluation.response().grid().angles(), angle -> angle),
                        evaluation.response().values()[0])
                .draw();
    }

    private static void drawPeaks(Ridge ridge, HeatMap map) {
        String name = Text.format(
                "brightest angle at each wavelength (mean %.1f nm)",
                ridge.statistics().getMean() * 1e9);
        map.curve(name, nanometers(ridge.wavelengths()), degrees(ridge.angles(), angle -> angle), PEAKS, true);
    }

    private static void drawFitted(Ridge ridge, ResponseGrid grid, HeatMap map) {
        double period = ridge.statistics().getMean();
        map.curve(
                "grating equation for the peaks' mean",
                nanometers(grid.wavelengths()),
                degrees(grid.wavelengths(), wavelength -> grid.plane().thetaR(ridge.order() * wavelength / period)),
                FITTED,
                false);
    }

    private static void drawEquation(GratingPeriod period, Evaluation evaluation, HeatMap map) {
        ResponseGrid grid = evaluation.response().grid();
        GratingPlane plane = grid.plane();
        boolean towardsNormal = !Double.isNaN(plane.thetaR(-grid.wavelengths()[0] / period.period()));
        int order = evaluation.ridge().map(Ridge::order).orElse(towardsNormal ? -1 : 1);
        map.interval(
                "the period, " + period.interval().replace(", 95 % interval", "; dotted: 95 % interval"),
                nanometers(grid.wavelengths()),
                degrees(grid.wavelengths(), wavelength -> plane.thetaR(order * wavelength / period.period())),
                degrees(grid.wavelengths(), wavelength -> plane.thetaR(order * wavelength / period.low())),
                degrees(grid.wavelengths(), wavelength -> plane.thetaR(order * wavelength / period.high())),
                EQUATION);
    }

    private static double[] nanometers(double[] meters) {
        return Arrays.stream(meters).map(value -> value * 1e9).toArray();
    }

    private static double[] degrees(double[] values, DoubleUnaryOperator radians) {
        return Arrays.stream(values)
                .map(value -> Math.toDegrees(radians.applyAsDouble(value)))
                .toArray();
    }
}
