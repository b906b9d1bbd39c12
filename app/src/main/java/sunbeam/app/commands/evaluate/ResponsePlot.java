package sunbeam.app.commands.evaluate;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import sunbeam.app.files.plot.ColorMap;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.Plot;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.evaluation.Ridge;

/**
 * The thesis's figures 4.9 to 4.11: the response in color and its followed peaks; and the period that is told, as the
 * curves of the grating equation for it and for the ends of its interval.
 */
final class ResponsePlot {
    private static final int WIDTH = 1100;
    private static final int HEIGHT = 800;
    // Decades of the response that the colors span.
    private static final double SPAN = 1e-4;
    private static final int PEAKS = 0xFFFFFF;
    // No hue of VIRIDIS, and brighter than most of it to eyes that see no red.
    private static final int EQUATION = 0xFF7040;

    private ResponsePlot() {}

    static BufferedImage draw(
            String title,
            String quantity,
            ResponseMatrix response,
            Optional<GratingMeasurement> measurement,
            Optional<GratingPeriod> answer) {
        ResponseGrid grid = response.grid();
        double largest = Arrays.stream(response.values())
                .flatMapToDouble(Arrays::stream)
                .max()
                .orElseThrow();
        double high = largest > 0 ? largest : 1;
        HeatMap.Colors colors =
                new HeatMap.Colors(quantity, SPAN * high, high, Plot.Scale.LOGARITHMIC, ColorMap.VIRIDIS);
        double[] wavelengths = nanometres(grid.wavelengths());
        double[] angles = degrees(grid.angles());
        HeatMap map = new HeatMap(
                new HeatMap.Frame(
                        title, "wavelength / nm", "angle to the viewer theta_r / degrees", WIDTH, HEIGHT, false),
                new HeatMap.Values(
                        transposed(response.values()),
                        HeatMap.Values.around(wavelengths),
                        HeatMap.Values.around(angles),
                        colors,
                        HeatMap.Reduction.LARGEST));
        double away = answer.map(told -> sideAwayFromTheLight(told, grid)).orElse(-1.0);
        double sign = measurement.map(found -> (double) found.order()).orElse(away);
        answer.ifPresent(told -> draw(told, Math.signum(sign), grid, map));
        measurement.ifPresent(found -> draw(found, map));
        return map.draw();
    }

    private static void draw(GratingMeasurement measurement, HeatMap map) {
        Ridge ridge = measurement.ridge();
        String peaks = String.format(
                Locale.ROOT,
                "brightest angle at each wavelength (mean %.1f nm)",
                measurement.interpolated().mean() * 1e9);
        map.curve(peaks, nanometres(ridge.wavelengths()), degrees(ridge.peakAngles()), PEAKS, true);
    }

    /** -1 where the order on that side of the mirror is above the horizon, else 1. */
    private static double sideAwayFromTheLight(GratingPeriod answer, ResponseGrid grid) {
        return Double.isNaN(grid.plane().thetaR(-grid.wavelengths()[0] / answer.period())) ? 1 : -1;
    }

    /** The grating equation for the period and both ends of its interval. */
    private static void draw(GratingPeriod answer, double sign, ResponseGrid grid, HeatMap map) {
        double[] periods = {answer.period(), answer.low(), answer.high()};
        double[][] angles = Arrays.stream(periods)
                .mapToObj(period -> Arrays.stream(grid.wavelengths())
                        .map(wavelength -> grid.plane().thetaR(sign * wavelength / period))
                        .map(Math::toDegrees)
                        .toArray())
                .toArray(double[][]::new);
        String name = "the period, " + answer.describe().replace(", 95 % interval", "; dotted: 95 % interval");
        map.interval(name, nanometres(grid.wavelengths()), angles[0], angles[1], angles[2], EQUATION);
    }

    private static double[][] transposed(double[][] values) {
        double[][] result = new double[values[0].length][values.length];
        for (int row = 0; row < values.length; row++) {
            for (int column = 0; column < values[row].length; column++) {
                result[column][row] = values[row][column];
            }
        }
        return result;
    }

    private static double[] nanometres(double[] metres) {
        return Arrays.stream(metres).map(value -> value * 1e9).toArray();
    }

    private static double[] degrees(double[] radians) {
        return Arrays.stream(radians).map(Math::toDegrees).toArray();
    }
}
