package sunbeam.precompute.reference;

/** A complex weight for each sample along one axis. */
record AxisWeights(double[] real, double[] imaginary) {

    /** exp(+2 pi i f_j x) / N of one DFT bin. */
    static AxisWeights ofBin(int bin, Axis axis) {
        AxisWeights weights = new AxisWeights(new double[axis.count()], new double[axis.count()]);
        int direction = axis.step() < 0 ? -1 : 1;
        for (int i = 0; i < axis.count(); i++) {
            long turns = Math.floorMod((long) bin * (i - axis.origin()) * direction, (long) axis.count());
            weights.add(i, 1.0 / axis.count(), (double) turns / axis.count());
        }
        return weights;
    }

    /**
     * g(x) exp(+2 pi i f x) / sum g, summed over all replicas of the patch that lie under the window.
     *
     * @param reach how many standard deviations the window extends
     */
    static AxisWeights ofWindow(double frequency, Axis axis, double sigma, double reach) {
        AxisWeights weights = new AxisWeights(new double[axis.count()], new double[axis.count()]);
        long extent = (long) Math.floor(reach * sigma / Math.abs(axis.step()));
        double total = 0;
        for (long offset = -extent; offset <= extent; offset++) {
            double position = offset * axis.step();
            double gauss = Math.exp(-0.5 * position * position / (sigma * sigma));
            total += gauss;
            weights.add((int) Math.floorMod(axis.origin() + offset, (long) axis.count()), gauss, frequency * position);
        }
        for (int i = 0; i < axis.count(); i++) {
            weights.real[i] /= total;
            weights.imaginary[i] /= total;
        }
        return weights;
    }

    /**
     * exp(+2 pi i f x) / (N Q), summed over Q replicas of the patch side by side, one after the other.
     *
     * @param replicas Q, at least 1
     */
    static AxisWeights ofReplicas(double frequency, Axis axis, int replicas) {
        AxisWeights weights = new AxisWeights(new double[axis.count()], new double[axis.count()]);
        double amount = 1.0 / axis.count() / replicas;
        for (int replica = 0; replica < replicas; replica++) {
            for (int i = 0; i < axis.count(); i++) {
                double position = ((double) replica * axis.count() + i) * axis.step();
                weights.add(i, amount, frequency * position);
            }
        }
        return weights;
    }

    private void add(int index, double amount, double turns) {
        double angle = 2 * Math.PI * (turns - Math.rint(turns));
        real[index] += amount * Math.cos(angle);
        imaginary[index] += amount * Math.sin(angle);
    }
}
