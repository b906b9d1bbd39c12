package sunbeam.precompute.reference;

/**
 * The coherence window along one axis, sampled with the patch's pitch and divided by its sum.
 *
 * @param amplitudes by distance from the maximum in samples, on either side
 */
record WindowSamples(double[] amplitudes) {

    /** @param reach how many standard deviations the window extends */
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
