package sunbeam.precompute.fourier;

import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;

/**
 * Inverse DFT of one period, limited to a band of bins: X_j = (1/N) sum_n x_n exp(+2 pi i n j / N) for the bins j of a {@link Band}:
 * Commons Math's FFT where N is a power of two, a {@link GridTransform} over it otherwise. The band may be longer than N, since the DFT is
 * periodic. Immutable and thread-safe.
 */
public final class BandTransform {
    private final int length;
    private final Band band;
    private final GridTransform grid;

    public BandTransform(int length, Band band) {
        this.length = length;
        this.band = band;
        boolean powerOfTwo = length > 1 && Integer.bitCount(length) == 1;
        this.grid = powerOfTwo ? null : new GridTransform(length, band);
    }

    public Band band() {
        return band;
    }

    public ComplexVector workspace() {
        return ComplexVector.zeros(length);
    }

    /** Transforms the first N values of {@code work} (overwritten) and writes the band to {@code target}, in steps of {@code stride}. */
    public void transform(ComplexVector work, ComplexVector target, int offset, int stride) {
        if (grid == null) {
            double[][] data = {work.real(), work.imaginary()};
            FastFourierTransformer.transformInPlace(data, DftNormalization.STANDARD, TransformType.INVERSE);
            for (int m = 0, index = offset; m < band.count(); m++, index += stride) {
                int bin = Math.floorMod(band.first() + m, length);
                target.real()[index] = work.real()[bin];
                target.imaginary()[index] = work.imaginary()[bin];
            }
        } else {
            grid.transform(work, 1.0 / length, target, offset, stride);
        }
    }
}
