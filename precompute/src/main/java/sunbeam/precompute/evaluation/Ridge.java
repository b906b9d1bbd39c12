package sunbeam.precompute.evaluation;

import java.util.stream.IntStream;

/**
 * A followed ridge: where the response peaks at each wavelength.
 *
 * @param plane of the directions
 * @param wavelengths at which it was met, metres, ascending
 * @param peakAngles tops of the parabolas through the logarithms of the three samples at each peak, radians
 * @param sampleAngles the grid's angles nearest to the peaks, radians: the thesis's peaks
 */
public record Ridge(GratingPlane plane, double[] wavelengths, double[] peakAngles, double[] sampleAngles) {
    public Ridge {
        if (wavelengths.length != peakAngles.length || wavelengths.length != sampleAngles.length) {
            throw new IllegalArgumentException("a ridge needs an angle for each wavelength");
        }
    }

    public int size() {
        return wavelengths.length;
    }

    /** d = lambda / |u| at each wavelength, from interpolated peaks, metres. */
    public double[] periods() {
        return periods(peakAngles);
    }

    /** d = lambda / |u| at each wavelength, from peaks on the grid, metres. */
    public double[] sampledPeriods() {
        return periods(sampleAngles);
    }

    private double[] periods(double[] angles) {
        return IntStream.range(0, size())
                .mapToDouble(i -> wavelengths[i] / Math.abs(plane.u(angles[i])))
                .toArray();
    }
}
