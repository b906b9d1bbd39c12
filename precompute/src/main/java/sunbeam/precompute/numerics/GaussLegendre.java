package sunbeam.precompute.numerics;

/**
 * Gauss-Legendre quadrature rule over -1..1: its nodes, ascending, and their weights, whose sum is 2. The zeros of Legendre's
 * polynomial are found by Newton's method, in a time that grows with the square of their number.
 */
public record GaussLegendre(double[] nodes, double[] weights) {
    // Newton's method doubles the digits of a start with four of them; the rest is for zeros next to the ends.
    private static final int ITERATIONS = 6;

    /**
     * Computes a rule.
     *
     * @param count number of nodes, at least 1
     */
    public static GaussLegendre of(int count) {
        double[] nodes = new double[count];
        double[] weights = new double[count];
        for (int i = 0; i < count; i++) {
            double x = -Math.cos(Math.PI * (i + 0.75) / (count + 0.5));
            double derivative = 0;
            for (int iteration = 0; iteration < ITERATIONS; iteration++) {
                double value = 1;
                double before = 0;
                for (int n = 1; n <= count; n++) {
                    double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
                    before = value;
                    value = next;
                }
                derivative = count * (before - x * value) / ((1 - x) * (1 + x));
                x -= value / derivative;
            }
            nodes[i] = x;
            weights[i] = 2 / ((1 - x) * (1 + x) * derivative * derivative);
        }
        return new GaussLegendre(nodes, weights);
    }
}
