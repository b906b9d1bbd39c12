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

    // Between waves of a lattice, radians.
    private static final double LEAST_ANGLE = Math.toRadians(10);

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

    /** Whether this is a line as sharp as a grating's that runs in another direction than one: the wave of a lattice. */
    public boolean isAcross(SpectrumPeak other) {
        return figure >= SharpLines.THRESHOLD && angle(other) > LEAST_ANGLE;
    }

    /** Between two waves' directions, of which the opposite is the same, radians. */
    private double angle(SpectrumPeak other) {
        return Math.abs(Math.IEEEremainder(direction() - other.direction(), Math.PI));
    }
}
