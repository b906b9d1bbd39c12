package sunbeam.precompute.reference;

import sunbeam.precompute.numerics.UnitCircle;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Evaluates coherent power like {@link ReferenceEvaluator}, but by a sum over samples instead of distinct heights, for a few directions of
 * a scan whose heights are nearly all different. Immutable and thread-safe.
 */
public final class CoherentSamples {
    private final HeightMap map;
    private final Axis axisX;
    private final Axis axisY;
    private final WindowSamples windowX;
    private final WindowSamples windowY;

    public CoherentSamples(HeightMap map, CoherenceWindow window, WindowOrigin origin) {
        this.map = map;
        this.axisX = Axis.x(map, origin);
        this.axisY = Axis.y(map, origin);
        this.windowX = WindowSamples.of(axisX, window.sigmaMeters(), ReferenceEvaluator.AMPLITUDE_REACH);
        this.windowY = WindowSamples.of(axisY, window.sigmaMeters(), ReferenceEvaluator.AMPLITUDE_REACH);
    }

    /**
     * Powers in one direction.
     *
     * @param specular squared magnitude of the mean of exp(i k w h) over all samples: in the mirror direction, the share of light in the
     *     specular order
     */
    public record Sample(double coherent, double specular) {}

    /** Returns the powers at a wavelength in meters. */
    public Sample at(DirectionPair pair, double wavelength) {
        int columns = map.columns();
        AxisWeights alongX = AxisWeights.ofWindow(pair.u() / wavelength, axisX, windowX);
        AxisWeights alongY = AxisWeights.ofWindow(pair.v() / wavelength, axisY, windowY);
        AxisSums windowed = new AxisSums(columns, 1);
        double phasePerMeter = 2 * Math.PI / wavelength * pair.w();
        // Heights with an offset of millimeters would lose digits of the phase.
        double zero = map.at(0, 0);
        double[] real = new double[columns];
        double[] imaginary = new double[columns];
        double sumReal = 0;
        double sumImaginary = 0;
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < columns; column++) {
                imaginary[column] = phasePerMeter * (map.at(column, row) - zero);
            }
            // Replaces the phases by their sines.
            UnitCircle.points(imaginary, real);
            windowed.add(0, real, imaginary, alongY.real()[row], alongY.imaginary()[row]);
            double rowReal = 0;
            double rowImaginary = 0;
            for (int column = 0; column < columns; column++) {
                rowReal += real[column];
                rowImaginary += imaginary[column];
            }
            sumReal += rowReal;
            sumImaginary += rowImaginary;
        }
        double samples = (double) columns * map.rows();
        double meanReal = sumReal / samples;
        double meanImaginary = sumImaginary / samples;
        return new Sample(windowed.power(0, alongX), meanReal * meanReal + meanImaginary * meanImaginary);
    }
}
