package sunbeam.app.commands.evaluate;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Locale;
import sunbeam.app.files.plot.ColorMap;
import sunbeam.app.files.plot.HeatMap;
import sunbeam.app.files.plot.Plot;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.evaluation.Ridge;

/** The thesis's figures 4.9 to 4.11: the response in colour, its followed peaks and the grating equation. */
final class ResponsePlot {
    private static final int WIDTH = 1100;
    private static final int HEIGHT = 800;
    // Decades of the response that the colours span.
    private static final double SPAN = 1e-4;
    private static final int PEAKS = 0xFFFFFF;
    private static final int EQUATION = 0xFF5030;

    private ResponsePlot() {}

    static BufferedImage draw(String title, String quantity, ResponseMatrix response, GratingMeasurement measurement) {
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
        Ridge ridge = measurement.ridge();
        double frequency = measurement.fittedFrequency();
        String equation = String.format(Locale.ROOT, "grating equation, d = %.2f nm", measurement.fittedPeriod() * 1e9);
        map.curve(
                "peaks of the first order", nanometres(ridge.wavelengths()), degrees(ridge.peakAngles()), PEAKS, false);
        map.curve(equation, nanometres(ridge.wavelengths()), degrees(ridge.angles(frequency)), EQUATION, true);
        return map.draw();
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
