package sunbeam.precompute.reference;

/**
 * Coherence window along one axis, sampled at the patch's pitch; the samples add up to 1.
 *
 * @param amplitudes amplitude at each distance, in samples, from the maximum
 */
record WindowSamples(double[] amplitudes) {

    /** @param reach standard deviations up to which the window is sampled */
    static WindowSamples of(Axis axis, double sigma, double reach) {
        int extent = (int) Math.floor(reach * sigma / Math.abs(axis.step()));
        double[] amplitudes = new double[extent + 1];
        double total = 0;
        for (int i = extent; i >= 0; i--) {
            double deviations = i * axis.step() / sigma;
            amplitudes[i] = Math.exp(-0.5 * deviations * deviations);
            total += i == 0 ? amplitudes[i] : 2 * amplitudes[i];
        }
        for (int i = 0; i <= extent; i++) {
            amplitudes[i] /= total;
        }
        return new WindowSamples(amplitudes);
    }

    int extent() {
        return amplitudes.length - 1;
    }

    double at(long offset) {
        return amplitudes[(int) Math.abs(offset)];
    }
}
