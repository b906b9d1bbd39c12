package sunbeam.precompute.reference;

/** Complex weights of the samples along one axis. N is the number of samples and f a frequency in cycles per meter. */
record AxisWeights(double[] real, double[] imaginary) {

    /** Returns exp(+2 pi i f_j x) / N, where f_j is the frequency of a DFT bin. */
    static AxisWeights ofBin(int bin, Axis axis) {
        AxisWeights weights = new AxisWeights(new double[axis.count()], new double[axis.count()]);
        int direction = axis.step() < 0 ? -1 : 1;
        for (int i = 0; i < axis.count(); i++) {
            long steps = Math.floorMod((long) bin * (i - axis.origin()) * direction, (long) axis.count());
            double angle = angle((double) steps / axis.count());
            weights.real[i] = Math.cos(angle) / axis.count();
            weights.imaginary[i] = Math.sin(angle) / axis.count();
        }
        return weights;
    }

    /**
     * Returns g(x) exp(+2 pi i f x) / sum g, summed over all replicas of the patch under the window. The phase factor is that of the sample
     * times that of the replica: one sine for each, instead of one for each pair.
     */
    static AxisWeights ofWindow(double frequency, Axis axis, WindowSamples window) {
        AxisWeights weights = new AxisWeights(new double[axis.count()], new double[axis.count()]);
        long extent = window.extent();
        long firstReplica = Math.floorDiv(axis.origin() - extent, (long) axis.count());
        long lastReplica = Math.floorDiv(axis.origin() + extent, (long) axis.count());
        for (long replica = firstReplica; replica <= lastReplica; replica++) {
            long shift = replica * axis.count() - axis.origin();
            int first = (int) Math.max(0, -extent - shift);
            int last = (int) Math.min(axis.count() - 1, extent - shift);
            double angle = angle(frequency * axis.step() * axis.count() * replica);
            double cosine = Math.cos(angle);
            double sine = Math.sin(angle);
            for (int i = first; i <= last; i++) {
                double gauss = window.at(shift + i);
                weights.real[i] += gauss * cosine;
                weights.imaginary[i] += gauss * sine;
            }
        }
        for (int i = 0; i < axis.count(); i++) {
            weights.turn(i, angle(frequency * axis.step() * (i - axis.origin())));
        }
        return weights;
    }

    /** Returns exp(+2 pi i f x) / (N Q), summed over Q adjacent replicas of the patch. */
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
        real[index] += amount * Math.cos(angle(turns));
        imaginary[index] += amount * Math.sin(angle(turns));
    }

    private void turn(int index, double angle) {
        double cosine = Math.cos(angle);
        double sine = Math.sin(angle);
        double a = real[index];
        double b = imaginary[index];
        real[index] = a * cosine - b * sine;
        imaginary[index] = a * sine + b * cosine;
    }

    /** Whole turns are removed first, since they cost digits. */
    private static double angle(double turns) {
        return 2 * Math.PI * (turns - Math.rint(turns));
    }
}
