package sunbeam.precompute.reference;

import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.HeightMap;

/** Complex weights of the samples along one axis. N is the number of samples and f a frequency in cycles per meter. */
record AxisWeights(double[] real, double[] imaginary) {
    /**
     * Positions of samples, in steps (meters; negative along y, since rows run downwards) from {@code origin}, under the window's maximum.
     */
    record Axis(int count, double step, int origin) {
        static Axis x(HeightMap map, WindowOrigin origin) {
            return new Axis(map.columns(), map.pitchX(), origin.sample(map.columns()));
        }

        static Axis y(HeightMap map, WindowOrigin origin) {
            return new Axis(map.rows(), -map.pitchY(), origin.sample(map.rows()));
        }

        double period() {
            return count * Math.abs(step);
        }

        /** Returns the window's amplitudes at each distance, in samples, from its maximum, up to {@code reach} sigma; their sum is 1. */
        double[] window(double sigma, double reach) {
            int extent = (int) Math.floor(reach * sigma / Math.abs(step));
            double[] amplitudes = new double[extent + 1];
            double total = 0;
            for (int i = extent; i >= 0; i--) {
                double deviations = i * step / sigma;
                amplitudes[i] = Math.exp(-0.5 * deviations * deviations);
                total += i == 0 ? amplitudes[i] : 2 * amplitudes[i];
            }
            for (int i = 0; i <= extent; i++) {
                amplitudes[i] /= total;
            }
            return amplitudes;
        }
    }

    private AxisWeights(Axis axis) {
        this(new double[axis.count], new double[axis.count]);
    }

    /** Returns exp(+2 pi i f_j x) / N, where f_j is the frequency of a DFT bin. */
    static AxisWeights ofBin(int bin, Axis axis) {
        AxisWeights weights = new AxisWeights(axis);
        int direction = axis.step < 0 ? -1 : 1;
        for (int i = 0; i < axis.count; i++) {
            long steps = Math.floorMod((long) bin * (i - axis.origin) * direction, (long) axis.count);
            weights.add(i, 1.0 / axis.count, angle((double) steps / axis.count));
        }
        return weights;
    }

    /**
     * Returns g(x) exp(+2 pi i f x) / sum g, for the amplitudes g of {@link Axis#window}, summed over all replicas of the patch. A phase
     * factor is that of the sample times that of the replica: one sine for each, not for each pair.
     */
    static AxisWeights ofWindow(double frequency, Axis axis, double[] window) {
        AxisWeights weights = new AxisWeights(axis);
        long extent = window.length - 1L;
        long firstReplica = Math.floorDiv(axis.origin - extent, (long) axis.count);
        long lastReplica = Math.floorDiv(axis.origin + extent, (long) axis.count);
        for (long replica = firstReplica; replica <= lastReplica; replica++) {
            long shift = replica * axis.count - axis.origin;
            int first = (int) Math.max(0, -extent - shift);
            int last = (int) Math.min(axis.count - 1, extent - shift);
            double angle = angle(frequency * axis.step * axis.count * replica);
            double cosine = Math.cos(angle);
            double sine = Math.sin(angle);
            for (int i = first; i <= last; i++) {
                double gauss = window[(int) Math.abs(shift + i)];
                weights.real[i] += gauss * cosine;
                weights.imaginary[i] += gauss * sine;
            }
        }
        for (int i = 0; i < axis.count; i++) {
            weights.turn(i, angle(frequency * axis.step * (i - axis.origin)));
        }
        return weights;
    }

    /** Returns exp(+2 pi i f x) / (N Q), summed over Q adjacent replicas of the patch. */
    static AxisWeights ofReplicas(double frequency, Axis axis, int replicas) {
        AxisWeights weights = new AxisWeights(axis);
        double amount = 1.0 / axis.count / replicas;
        for (int replica = 0; replica < replicas; replica++) {
            for (int i = 0; i < axis.count; i++) {
                double position = ((double) replica * axis.count + i) * axis.step;
                weights.add(i, amount, angle(frequency * position));
            }
        }
        return weights;
    }

    private void add(int index, double amount, double angle) {
        real[index] += amount * Math.cos(angle);
        imaginary[index] += amount * Math.sin(angle);
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
