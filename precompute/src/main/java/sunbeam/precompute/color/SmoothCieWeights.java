package sunbeam.precompute.color;

/**
 * CIE weights without the kinks of the linear interpolation, which on the flanks of the color matching functions lies up to 1.5e-3 above
 * the smooth function. An integral averages this excess; nodes a nanometer or more apart do not. The table is filtered with (w[i-1] + 10
 * w[i] + w[i+1]) / 12, which adds the chords' mean excess, and a cubic spline interpolates it (Catmull and Rom 1974).
 */
public final class SmoothCieWeights {
    private static final int TABLE_LAST = 400;
    private static final int PER_NANOMETER = 8;
    /** Eight samples per nanometer from 380 to 780 nm, both ends included. */
    public static final int SAMPLES = TABLE_LAST * PER_NANOMETER + 1;

    private SmoothCieWeights() {}

    /** Returns the wavelength of a sample, meters. */
    public static double wavelength(int sample) {
        return CieTable.MINIMUM_WAVELENGTH + sample * (1e-9 / PER_NANOMETER);
    }

    /** Returns S xbar, S ybar or S zbar at each sample, not normalized; channel 0, 1 or 2. */
    public static double[] of(CieTable cie, int channel) {
        double[] smooth = new double[TABLE_LAST + 1];
        for (int i = 0; i <= TABLE_LAST; i++) {
            smooth[i] = (at(cie, i - 1, channel) + 10 * at(cie, i, channel) + at(cie, i + 1, channel)) / 12;
        }
        double[] result = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            int left = Math.min(TABLE_LAST - 1, i / PER_NANOMETER);
            result[i] = cubic(smooth, left, (double) i / PER_NANOMETER - left);
        }
        return result;
    }

    /** Extrapolates linearly beyond the band's ends. */
    private static double at(CieTable cie, int nanometer, int channel) {
        int inside = Math.min(TABLE_LAST, Math.max(0, nanometer));
        double value = cie.at(CieTable.MINIMUM_WAVELENGTH + inside * 1e-9, channel);
        int inwards = Integer.compare(inside, nanometer);
        return inwards == 0
                ? value
                : 2 * value - cie.at(CieTable.MINIMUM_WAVELENGTH + (inside + inwards) * 1e-9, channel);
    }

    private static double cubic(double[] values, int left, double t) {
        double from = values[left];
        double to = values[left + 1];
        double before = left == 0 ? 2 * from - to : values[left - 1];
        double after = left + 2 > TABLE_LAST ? 2 * to - from : values[left + 2];
        double slope = 0.5 * (to - before);
        double bend = before - 2.5 * from + 2 * to - 0.5 * after;
        double twist = 0.5 * (after - before) + 1.5 * (from - to);
        return from + t * (slope + t * (bend + t * twist));
    }
}
