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
    private static final double STEP = 0.15;
    // Places two steps apart: as far as 1.2 on either side.
    private static final int COARSE = 9;
    private static final int WAVELENGTHS = 7;
    // Of a scan with more samples, whose sums take long and whose orders are sharp, fewer.
    private static final int FEW_WAVELENGTHS = 4;
    private static final long MANY_SAMPLES = 4_000_000;

    private final FadedEvaluator light;
    private final GratingPlane plane;
    private final double length;
    private final int most;

    /** @param scan as it was measured, with no edges treated */
    public FadedRidge(HeightMap scan, GratingPlane plane) {
        this.light = new FadedEvaluator(scan);
        this.plane = plane;
        this.length = length(scan, plane);
        this.most = (long) scan.columns() * scan.rows() > MANY_SAMPLES ? FEW_WAVELENGTHS : WAVELENGTHS;
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
     * @param summed told of each direct sum over the scan, up to {@link #mostSums()} of them; from several threads
     */
    public OptionalDouble period(PeriodEstimate told, double[] wavelengths, Runnable summed) {
        int count = Math.min(most, wavelengths.length);
        double[] found = IntStream.range(0, count)
                .parallel()
                .mapToDouble(i -> period(
                        told,
                        wavelengths[(int) Math.round(i * (wavelengths.length - 1.0) / Math.max(1, count - 1))],
                        summed))
                .filter(period -> !Double.isNaN(period))
                .toArray();
        return found.length < 3 ? OptionalDouble.empty() : Arrays.stream(found).average();
    }

    /** Direct sums that {@link #period} takes at most. */
    public int mostSums() {
        return most * (2 + COARSE + 2);
    }

    /**
     * At one wavelength, on the side where the order is brighter; NaN where it is not above the horizon, or has no top. The
     * order is 4 / length wide, so that every second place finds the top, and its neighbours the rest.
     */
    private double period(PeriodEstimate told, double wavelength, Runnable summed) {
        double here = 1 / told.period();
        double step = STEP / length;
        double sign = power(here, wavelength, summed) > power(-here, wavelength, summed) ? 1 : -1;
        double[] coarse = new double[COARSE];
        for (int i = 0; i < COARSE; i++) {
            coarse[i] = power(sign * (here + (2 * i - COARSE + 1) * step), wavelength, summed);
        }
        int best = -1;
        for (int i = 1; i + 1 < COARSE; i++) {
            boolean top = coarse[i] > coarse[i - 1] && coarse[i] >= coarse[i + 1];
            best = top && (best < 0 || coarse[i] > coarse[best]) ? i : best;
        }
        if (best < 0) {
            return Double.NaN;
        }
        double middle = here + (2 * best - COARSE + 1) * step;
        double before = power(sign * (middle - step), wavelength, summed);
        double after = power(sign * (middle + step), wavelength, summed);
        double[] powers = {coarse[best - 1], before, coarse[best], after, coarse[best + 1]};
        int top = powers[1] > powers[2] ? 1 : powers[3] > powers[2] ? 3 : 2;
        if (!(powers[top - 1] > 0 && powers[top + 1] > 0)) {
            return Double.NaN;
        }
        return 1 / (middle + (top - 2 + LogParabola.top(powers[top - 1], powers[top], powers[top + 1])) * step);
    }

    /** At a frequency u / lambda; 0 where no direction has it. */
    private double power(double frequency, double wavelength, Runnable summed) {
        double thetaR = plane.thetaR(frequency * wavelength);
        boolean seen = !Double.isNaN(thetaR) && Math.abs(thetaR) <= plane.largestThetaR();
        double power = seen ? light.power(plane.pair(thetaR), wavelength) : 0;
        summed.run();
        return power;
    }
}
