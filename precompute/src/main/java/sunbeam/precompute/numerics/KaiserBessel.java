package sunbeam.precompute.numerics;

/**
 * Kaiser-Bessel interpolation kernel over {@code taps} grid points with the shape parameter beta (Kaiser 1966; Jackson et al. 1991):
 *
 * <pre>phi(x) = I0(beta sqrt(1 - (2 x / taps)^2)) / I0(beta),  |x| &lt; taps / 2</pre>
 */
public record KaiserBessel(int taps, double beta, double peak) {
    public KaiserBessel(int taps, double beta) {
        this(taps, beta, besselI0(beta));
    }

    public double value(double x) {
        double ratio = 2 * x / taps;
        return ratio * ratio >= 1 ? 0 : besselI0(beta * Math.sqrt(1 - ratio * ratio)) / peak;
    }

    /** Returns the Fourier transform at a frequency in cycles per grid step. */
    public double transform(double frequency) {
        double turns = Math.PI * taps * frequency;
        double square = beta * beta - turns * turns;
        double root = Math.sqrt(Math.abs(square));
        double shape = root < 1e-6 ? 1 : (square > 0 ? Math.sinh(root) : Math.sin(root)) / root;
        return shape * taps / peak;
    }

    /** I0 by its power series; all terms are positive, so none cancel. */
    private static double besselI0(double x) {
        double term = 1;
        double sum = 1;
        for (int k = 1; term > 1e-17 * sum; k++) {
            term *= x * x / (4.0 * k * k);
            sum += term;
        }
        return sum;
    }
}
