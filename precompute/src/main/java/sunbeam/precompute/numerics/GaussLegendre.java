package sunbeam.precompute.numerics;

/** Gauss-Legendre rule over -1..1: ascending nodes, and weights with the sum 2. Newton's method finds Legendre's zeros. */
public record GaussLegendre(double[] nodes, double[] weights) {
    // Four digits at the start, doubled by each iteration; zeros near the ends start worse.
    private static final int ITERATIONS = 6;

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
