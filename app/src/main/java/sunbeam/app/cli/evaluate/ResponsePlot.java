package sunbeam.app.cli.evaluate;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.HeatMap.ColorMap;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.files.plot.Sheet;
import sunbeam.precompute.analysis.GratingPeriod;
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
    private static final String ANGLE = "angle to the viewer theta_r / degrees";
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
        double[] wavelengths = map(grid.wavelengths(), meters -> meters * 1e9);
        double[] angles = map(grid.angles(), Math::toDegrees);
        if (wavelengths.length == 1) {
            String lit = Text.format("%s, %.4g nm", title, wavelengths[0]);
            return Plot.linear(lit, ANGLE, "relative radiance rho", WIDTH, HEIGHT)
                    .line("response", angles, values[0])
                    .draw();
        }
        double largest =
                Arrays.stream(values).flatMapToDouble(Arrays::stream).max().orElseThrow();
        double high = largest > 0 ? largest : 1;
        double[][] rows = new double[angles.length][values.length];
        for (int row = 0; row < rows.length; row++) {
            for (int column = 0; column < values.length; column++) {
                rows[row][column] = values[column][row];
            }
        }
        HeatMap map = new HeatMap(
                new HeatMap.Frame(title, "wavelength / nm", ANGLE, WIDTH, HEIGHT, false),
                new HeatMap.Values(
                        rows,
                        HeatMap.Values.around(wavelengths),
                        HeatMap.Values.around(angles),
                        new HeatMap.Colors(
                                "relative radiance rho", SPAN * high, high, Plot.Scale.LOGARITHMIC, ColorMap.VIRIDIS),
                        HeatMap.Reduction.LARGEST));
        GratingPeriod period = evaluation.period();
        if (period.isSure()) {
            boolean towardsNormal = !Double.isNaN(grid.plane().thetaR(-grid.wavelengths()[0] / period.period()));
            int order = evaluation.ridge().map(Ridge::order).orElse(towardsNormal ? -1 : 1);
            map.interval(
                    "the period, " + period.interval().replace(", 95 % interval", "; dotted: 95 % interval"),
                    wavelengths,
                    equation(grid, order, period.period()),
                    equation(grid, order, period.low()),
                    equation(grid, order, period.high()),
                    EQUATION);
        }
        evaluation.ridge().ifPresent(ridge -> {
            double mean = ridge.statistics().getMean();
            double[] fitted = equation(grid, ridge.order(), mean);
            map.curve("grating equation for the peaks' mean", wavelengths, fitted, FITTED, false);
            String name = Text.format("brightest angle at each wavelength (mean %.1f nm)", mean * 1e9);
            double[] ridgeWavelengths = map(ridge.wavelengths(), meters -> meters * 1e9);
            map.curve(name, ridgeWavelengths, map(ridge.angles(), Math::toDegrees), PEAKS, true);
        });
        return map.draw();
    }

    private static double[] equation(ResponseGrid grid, int order, double period) {
        return map(grid.wavelengths(), wavelength -> Math.toDegrees(grid.plane().thetaR(order * wavelength / period)));
    }

    private static double[] map(double[] values, DoubleUnaryOperator function) {
        return Arrays.stream(values).map(function).toArray();
    }
}
