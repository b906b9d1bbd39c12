package sunbeam.precompute.color;

import java.util.function.DoubleUnaryOperator;

/** Integrates a spectrum of power to X, Y, Z over 380..780 nm, to nine digits. Halves the step of 1 / lambda until the result converges. */
public final class ExactIntegral {
    /** Relative change of X, Y, Z at which halving ends. At half the step, polynomials of degree 11 err a thousand times less. */
    public static final double CONVERGED = 3e-8;

    // Amplitudes are sums of total magnitude 1 with errors near 1e-15. A power p errs by this times sqrt(p).
    private static final double AMPLITUDE_ROUNDING = 1e-14;
    private static final int MOST_HALVINGS = 6;

    private ExactIntegral() {}

    /**
     * Integrates a power.
     *
     * @param power function of the wavelength in meters; also evaluated slightly outside the band
     * @param firstStep step of 1 / lambda in cycles per meter that resolves the power's structure
     * @throws ArithmeticException when halving does not converge
     */
    public static double[] xyz(CieTable cie, DoubleUnaryOperator power, double firstStep) {
        double[] coarse = IntegratedNodes.of(cie, firstStep).sum(power);
        for (int halving = 1; halving <= MOST_HALVINGS; halving++) {
            double[] fine =
                    IntegratedNodes.of(cie, Math.scalb(firstStep, -halving)).sum(power);
            double change = 0;
            double largest = 0;
            for (int c = 0; c < 3; c++) {
                change = Math.max(change, Math.abs(fine[c] - coarse[c]));
                largest = Math.max(largest, Math.abs(fine[c]));
            }
            if (change <= CONVERGED * largest + AMPLITUDE_ROUNDING * (Math.sqrt(largest) + AMPLITUDE_ROUNDING)) {
                return fine;
            }
            coarse = fine;
        }
        throw new ArithmeticException("no convergence in steps of " + firstStep + " cycles per meter");
    }
}
