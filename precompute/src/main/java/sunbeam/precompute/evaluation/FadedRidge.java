package sunbeam.precompute.evaluation;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.numerics.LogParabola;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.reference.FadedEvaluator;

/**
 * The first order of a scan alone, faded to zero at its border: where it stands at a few wavelengths, found by direct sums
 * around the place where the heights have it.
 */
public final class FadedRidge {
    // Around the heights' frequency, in units of 1 / length: the faded order is 2 wide on either side.
    private static final double REACH = 1.2;
    private static final double STEP = 0.15;
    private static final int WAVELENGTHS = 7;

    private final FadedEvaluator light;
    private final GratingPlane plane;
    private final double length;

    /** @param scan as it was measured, with no edges treated */
    public FadedRidge(HeightMap scan, GratingPlane plane) {
        this.light = new FadedEvaluator(scan);
        this.plane = plane;
        this.length = length(scan, plane);
    }

    /** Of the scan along the grating's direction, metres. */
    private static double length(HeightMap scan, GratingPlane plane) {
        double cosine = Math.abs(Math.cos(plane.azimuth()));
        double sine = Math.abs(Math.sin(plane.azimuth()));
        return Math.min(scan.width() / Math.max(1e-12, cosine), scan.height() / Math.max(1e-12, sine));
    }

    /** Whether the heights' line is as sharp as the scan allows: no speckle, of which the brightest would be followed. */
    public static boolean isSharp(PeriodEstimate told, HeightMap scan, GratingPlane plane) {
        return 1 / told.low() - 1 / told.high() < 1 / length(scan, plane);
    }

    /**
     * The mean of the periods that the wavelengths show; empty where fewer than three show one.
     *
     * @param told by the heights
     * @param wavelengths metres; some of them are looked at
     */
    public OptionalDouble period(PeriodEstimate told, double[] wavelengths) {
        int count = Math.min(WAVELENGTHS, wavelengths.length);
        double[] found = IntStream.range(0, count)
                .parallel()
                .mapToDouble(i -> period(
                        told, wavelengths[(int) Math.round(i * (wavelengths.length - 1.0) / Math.max(1, count - 1))]))
                .filter(period -> !Double.isNaN(period))
                .toArray();
        return found.length < 3 ? OptionalDouble.empty() : Arrays.stream(found).average();
    }

    /** At one wavelength, on the side where the order is brighter; NaN where it is not above the horizon, or has no top. */
    private double period(PeriodEstimate told, double wavelength) {
        double best = 0;
        double period = Double.NaN;
        for (int sign = -1; sign <= 1; sign += 2) {
            int steps = (int) Math.ceil(REACH / STEP);
            double step = STEP / length;
            double[] powers = new double[2 * steps + 1];
            for (int i = -steps; i <= steps; i++) {
                powers[i + steps] = power(sign * (1 / told.period() + i * step), wavelength);
            }
            for (int i = 1; i + 1 < powers.length; i++) {
                boolean top = powers[i] > powers[i - 1] && powers[i] >= powers[i + 1] && powers[i] > best;
                if (top && powers[i - 1] > 0 && powers[i + 1] > 0) {
                    best = powers[i];
                    double shift = LogParabola.top(powers[i - 1], powers[i], powers[i + 1]);
                    period = 1 / (1 / told.period() + (i - steps + shift) * step);
                }
            }
        }
        return period;
    }

    /** At a frequency u / lambda; 0 where no direction has it. */
    private double power(double frequency, double wavelength) {
        double thetaR = plane.thetaR(frequency * wavelength);
        boolean seen = !Double.isNaN(thetaR) && Math.abs(thetaR) <= plane.largestThetaR();
        return seen ? light.power(plane.pair(thetaR), wavelength) : 0;
    }
}
