package sunbeam.precompute.analysis;

/**
 * A power spectrum along one line through zero frequency, averaged with a Gaussian along and, narrowly, across.
 *
 * @param step distance of the values, cycles per metre
 * @param power at frequencies 0, step, 2 step, ...
 */
record SpectrumLine(double step, double[] power) {
    private static final int STEPS_PER_BIN = 2;
    private static final int ACROSS = 3;
    private static final double REACH = 3;

    /**
     * Samples a spectrum.
     *
     * @param sigmaAlong of the Gaussian along the line, in bins
     * @param sigmaAcross of the Gaussian across it, cycles per metre
     */
    static SpectrumLine of(HeightSpectrum spectrum, double azimuth, double sigmaAlong, double sigmaAcross) {
        double cosine = Math.cos(azimuth);
        double sine = Math.sin(azimuth);
        double step = Math.hypot(cosine / spectrum.width(), sine / spectrum.height()) / STEPS_PER_BIN;
        int count = 1;
        while (spectrum.covers(count * step * cosine, count * step * sine)) {
            count++;
        }
        double[] raw = new double[count];
        for (int i = 0; i < count; i++) {
            double weights = 0;
            for (int j = -ACROSS; j <= ACROSS; j++) {
                double across = REACH * sigmaAcross * j / ACROSS;
                double weight = Math.exp(-0.5 * Math.pow(across / sigmaAcross, 2));
                double x = i * step * cosine - across * sine;
                double y = i * step * sine + across * cosine;
                raw[i] += weight * spectrum.interpolated(x, y);
                weights += weight;
            }
            raw[i] /= weights;
        }
        return new SpectrumLine(step, smoothed(raw, sigmaAlong * STEPS_PER_BIN));
    }

    /** Averages; what lies beyond zero frequency is the mirror image. */
    private static double[] smoothed(double[] raw, double sigma) {
        int radius = (int) Math.ceil(4 * sigma);
        double[] result = new double[raw.length];
        for (int i = 0; i < raw.length; i++) {
            double weights = 0;
            for (int j = i - radius; j <= Math.min(raw.length - 1, i + radius); j++) {
                double weight = Math.exp(-0.5 * Math.pow((j - i) / sigma, 2));
                int source = Math.abs(j);
                result[i] += source < raw.length ? weight * raw[source] : 0;
                weights += weight;
            }
            result[i] /= weights;
        }
        return result;
    }

    /** Power at a frequency, linear between samples; 0 beyond the last. */
    double at(double frequency) {
        double position = frequency / step;
        int index = (int) position;
        if (index < 0 || index + 1 >= power.length) {
            return 0;
        }
        return power[index] + (position - index) * (power[index + 1] - power[index]);
    }

    boolean isMaximum(int index) {
        return index > 0
                && index + 1 < power.length
                && power[index] > power[index - 1]
                && power[index] >= power[index + 1];
    }
}
