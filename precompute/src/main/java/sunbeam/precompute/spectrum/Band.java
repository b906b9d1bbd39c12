package sunbeam.precompute.spectrum;

/** Consecutive DFT bins along one axis: indices first .. first + count - 1, which may be negative. Bin j has the frequency j / period. */
public record Band(int first, int count) {
    public static Band of(int first, int last) {
        return new Band(first, last - first + 1);
    }

    public static Band covering(double minimumFrequency, double maximumFrequency, double period, int margin) {
        return of(
                (int) Math.floor(minimumFrequency * period) - margin,
                (int) Math.ceil(maximumFrequency * period) + margin);
    }

    public int last() {
        return first + count - 1;
    }

    public Band extended(int least) {
        return new Band(first, Math.max(count, least));
    }

    public boolean holds(int bin) {
        return bin >= first && bin <= last();
    }

    public Band widened(int margin) {
        return of(first - margin, last() + margin);
    }

    public Band symmetric() {
        int reach = Math.max(Math.abs(first), Math.abs(last()));
        return of(-reach, reach);
    }

    /** Returns the cosines and sines of 2 pi bin shift / samples of each bin, which move the origin of a DFT by {@code shift} samples. */
    public double[][] phases(int samples, int shift) {
        double[][] phases = new double[2][count];
        for (int i = 0; i < count; i++) {
            long turns = Math.floorMod((long) (first + i) * shift, (long) samples);
            double angle = 2 * Math.PI * turns / samples;
            phases[0][i] = Math.cos(angle);
            phases[1][i] = Math.sin(angle);
        }
        return phases;
    }
}
