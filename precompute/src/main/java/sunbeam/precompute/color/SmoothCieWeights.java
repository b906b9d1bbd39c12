package sunbeam.precompute.color;

/**
 * CIE weights without the kinks of the linear interpolation. Linear interpolation between whole nanometres lies up to 1.5e-3 above a
 * function that grows as fast as the flanks of the color matching functions; nodes a nanometre or more apart do not average that as an
 * integral does. A smooth function with the same spectrum at the wavelengths that matter takes its place: the table low-passed as its
 * chords are, (w[i-1] + 10 w[i] + w[i+1]) / 12, and a cubic between (Catmull and Rom 1974).
 */
public final class SmoothCieWeights {
    private static final int TABLE_LAST = 400;
    private static final int PER_NANOMETRE = 8;
    /** Eight samples a nanometre from 380 to 780 nm, both ends included. */
    public static final int SAMPLES = TABLE_LAST * PER_NANOMETRE + 1;

    private SmoothCieWeights() {}

    /** Wavelength of a sample, metres. */
    public static double wavelength(int sample) {
        return CieTable.MINIMUM_WAVELENGTH + sample * (1e-9 / PER_NANOMETRE);
    }

    /** S xbar, S ybar or S zbar, not normalised. */
    public static double[] of(CieTable cie, int channel) {
        double[] smooth = new double[TABLE_LAST + 1];
        for (int i = 0; i <= TABLE_LAST; i++) {
            smooth[i] = (at(cie, i - 1, channel) + 10 * at(cie, i, channel) + at(cie, i + 1, channel)) / 12;
        }
        double[] result = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            int left = Math.min(TABLE_LAST - 1, i / PER_NANOMETRE);
            result[i] = cubic(smooth, left, (double) i / PER_NANOMETRE - left);
        }
        return result;
    }

    /** Returns a table value, constant beyond the band's ends. */
    private static double at(CieTable cie, int nanometre, int channel) {
        int inside = Math.min(TABLE_LAST, Math.max(0, nanometre));
        double value = cie.at(CieTable.MINIMUM_WAVELENGTH + inside * 1e-9, channel);
        int inwards = Integer.compare(inside, nanometre);
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
