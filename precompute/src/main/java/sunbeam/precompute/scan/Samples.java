package sunbeam.precompute.scan;

/** What instruments do to the order and scale of samples, undone in place. Samples stand row by row. */
public final class Samples {
    private Samples() {}

    /** {@code factor * sample + offset} of each. */
    public static double[] scaled(double[] samples, double factor, double offset) {
        for (int i = 0; i < samples.length; i++) {
            samples[i] = factor * samples[i] + offset;
        }
        return samples;
    }

    /** The last row first: of files that begin at the bottom of the scan. */
    public static double[] upsideDown(double[] samples, int columns) {
        int rows = samples.length / columns;
        double[] row = new double[columns];
        for (int top = 0, bottom = rows - 1; top < bottom; top++, bottom--) {
            System.arraycopy(samples, top * columns, row, 0, columns);
            System.arraycopy(samples, bottom * columns, samples, top * columns, columns);
            System.arraycopy(row, 0, samples, bottom * columns, columns);
        }
        return samples;
    }

    /** The last column first: of files that begin at the right of the scan. */
    public static double[] mirrored(double[] samples, int columns) {
        for (int start = 0; start < samples.length; start += columns) {
            for (int left = start, right = start + columns - 1; left < right; left++, right--) {
                double sample = samples[left];
                samples[left] = samples[right];
                samples[right] = sample;
            }
        }
        return samples;
    }

    /** A value that stands for a missing sample replaced by NaN. */
    public static double[] withMissing(double[] samples, double mark) {
        for (int i = 0; i < samples.length; i++) {
            if (samples[i] == mark) {
                samples[i] = Double.NaN;
            }
        }
        return samples;
    }
}
