package sunbeam.precompute.expansion;

/**
 * Coefficients c_n(zeta) sampled at equal steps of the phase, real.
 *
 * @param minimumPhase zeta of the first sample
 * @param maximumPhase zeta of the last sample
 * @param values {@code [term][sample]}
 */
public record CoefficientTable(double minimumPhase, double maximumPhase, float[][] values) {

    public int samples() {
        return values[0].length;
    }

    public int terms() {
        return values.length;
    }
}
