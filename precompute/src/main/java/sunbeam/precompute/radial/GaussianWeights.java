package sunbeam.precompute.radial;

/** The bins along one axis that lend to a place among them, and how much each does: exp(-(distance / sigma_f)^2). Belongs to a thread. */
final class GaussianWeights {
    private final double ratio;
    private final double reach;
    private final double change;
    private final double[] weights;
    private int first;
    private int count;

    /**
     * Nothing is asked for yet.
     *
     * @param ratio distance of bins, in sigma_f
     * @param reach in sigma_f, beyond which a bin is left out
     */
    GaussianWeights(double ratio, double reach) {
        this.ratio = ratio;
        this.reach = reach;
        this.change = Math.exp(-2 * ratio * ratio);
        this.weights = new double[3 + (int) Math.ceil(2 * reach / ratio)];
    }

    /**
     * Goes to a place.
     *
     * @param place in bins
     * @param lowest bin that there is
     * @param highest bin that there is
     */
    void moveTo(double place, int lowest, int highest) {
        first = (int) Math.max(lowest, Math.ceil(place - reach / ratio));
        int last = (int) Math.min(highest, Math.floor(place + reach / ratio));
        count = Math.max(0, last - first + 1);
        // exp(-(x + i r)^2) = exp(-x^2) exp(-2 x r)^i exp(-r^2)^(i^2): two exponentials in place of one a bin.
        double distance = (first - place) * ratio;
        double weight = Math.exp(-distance * distance);
        double factor = Math.exp(-(2 * distance + ratio) * ratio);
        for (int i = 0; i < count; i++) {
            weights[i] = weight;
            weight *= factor;
            factor *= change;
        }
    }

    /** The first bin that lends. */
    int first() {
        return first;
    }

    /** How many lend, 0 where none does. */
    int count() {
        return count;
    }

    /** What the so many-th of them lends. */
    double weight(int index) {
        return weights[index];
    }

    /** What all of them lend, {@link #count()} values; others stand behind them. */
    double[] weights() {
        return weights;
    }
}
