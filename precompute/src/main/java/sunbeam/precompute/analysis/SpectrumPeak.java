package sunbeam.precompute.analysis;

/**
 * A regularity of a surface: a peak of its power spectrum.
 *
 * @param frequencyX cycles per metre
 * @param frequencyY cycles per metre, upwards
 * @param figure how clearly it stands out; see {@link Periodicity#figure}
 * @param rms root mean square of the heights that repeat so, metres
 */
public record SpectrumPeak(double frequencyX, double frequencyY, double figure, double rms) {

    /** Cycles per metre. */
    public double frequency() {
        return Math.hypot(frequencyX, frequencyY);
    }

    /** Metres. */
    public double period() {
        return 1 / frequency();
    }

    /** Across the ridges, radians counter-clockwise from +x, 0 to below pi. */
    public double direction() {
        double angle = Math.atan2(frequencyY, frequencyX);
        double positive = angle < 0 ? angle + Math.PI : angle;
        return positive >= Math.PI ? positive - Math.PI : positive;
    }
}
