package sunbeam.precompute.table;

import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform2d;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.patch.HeightLevels;

/** Transforms the terms T_n(h) of a patch into a {@link FourierTable}. */
public final class TableBuilder {
    private final PatchIdentity patch;
    private final HeightLevels heights;
    private final IntConsumer progress;

    /**
     * A builder for one patch.
     *
     * @param progress told after every transform how many terms are done
     */
    public TableBuilder(PatchIdentity patch, HeightLevels heights, IntConsumer progress) {
        this.patch = patch;
        this.heights = heights;
        this.progress = progress;
    }

    /** Bins of all terms of an expansion within the bands. */
    public FourierTable build(Expansion expansion, Band bandX, Band bandY) {
        float[][] real = new float[expansion.terms()][];
        float[][] imaginary = new float[expansion.terms()][];
        if (expansion.kind().hasRealBasis()) {
            transformPairs(expansion, bandX, bandY, real, imaginary);
        } else {
            transformSingly(expansion, bandX, bandY, real, imaginary);
        }
        return new FourierTable(
                patch,
                expansion.kind(),
                expansion.scale(),
                bandX,
                bandY,
                real,
                imaginary,
                expansion.kind() == ExpansionKind.TAYLOR
                        ? Optional.empty()
                        : Optional.of(CoefficientTable.sampled(expansion)));
    }

    private void transformSingly(Expansion expansion, Band bandX, Band bandY, float[][] real, float[][] imaginary) {
        BandTransform2d transform = new BandTransform2d(patch.columns(), patch.rows(), bandX, bandY);
        for (int n = 0; n < expansion.terms(); n++) {
            double[][] field = sample(expansion, n);
            ComplexVector bins = transform.transform(rowsOf(field[0], field[1]));
            real[n] = toFloat(bins.real());
            imaginary[n] = toFloat(bins.imaginary());
            progress.accept(n + 1);
        }
    }

    /** Two real terms a, b in one transform z = a + i b: A(f) = (Z(f) + Z*(-f)) / 2, B(f) = (Z(f) - Z*(-f)) / 2i. */
    private void transformPairs(Expansion expansion, Band bandX, Band bandY, float[][] real, float[][] imaginary) {
        Band wideX = bandX.symmetric();
        Band wideY = bandY.symmetric();
        BandTransform2d transform = new BandTransform2d(patch.columns(), patch.rows(), wideX, wideY);
        for (int n = 0; n < expansion.terms(); n += 2) {
            boolean pair = n + 1 < expansion.terms();
            double[] first = sample(expansion, n)[0];
            double[] second = pair ? sample(expansion, n + 1)[0] : new double[first.length];
            ComplexVector z = transform.transform(rowsOf(first, second));
            for (int term = n; term <= (pair ? n + 1 : n); term++) {
                real[term] = new float[bandX.count() * bandY.count()];
                imaginary[term] = new float[bandX.count() * bandY.count()];
                separate(z, wideX, wideY, bandX, bandY, term == n, real[term], imaginary[term]);
            }
            progress.accept(pair ? n + 2 : n + 1);
        }
    }

    private static void separate(
            ComplexVector z, Band wideX, Band wideY, Band bandX, Band bandY, boolean first, float[] re, float[] im) {
        int last = z.length() - 1;
        int target = 0;
        for (int jy = bandY.first(); jy <= bandY.last(); jy++) {
            for (int jx = bandX.first(); jx <= bandX.last(); jx++, target++) {
                int at = (jy - wideY.first()) * wideX.count() + jx - wideX.first();
                double a = z.real()[at];
                double b = z.imaginary()[at];
                double mirroredA = z.real()[last - at];
                double mirroredB = z.imaginary()[last - at];
                re[target] = (float) (0.5 * (first ? a + mirroredA : b + mirroredB));
                im[target] = (float) (0.5 * (first ? b - mirroredB : mirroredA - a));
            }
        }
    }

    /** T_n at every distinct height: real parts, imaginary parts. */
    private double[][] sample(Expansion expansion, int n) {
        double[] real = new double[heights.count()];
        double[] imaginary = new double[heights.count()];
        IntStream.range(0, real.length).parallel().forEach(i -> {
            Complex value = expansion.basis(n, expansion.scale().scaled(heights.levels()[i]));
            real[i] = value.getReal();
            imaginary[i] = value.getImaginary();
        });
        return new double[][] {real, imaginary};
    }

    private BandTransform2d.RowSource rowsOf(double[] realLevels, double[] imaginaryLevels) {
        int[] index = heights.index();
        int columns = patch.columns();
        return (row, real, imaginary) -> {
            for (int column = 0, i = row * columns; column < columns; column++, i++) {
                real[column] = realLevels[index[i]];
                imaginary[column] = imaginaryLevels[index[i]];
            }
        };
    }

    private static float[] toFloat(double[] values) {
        float[] result = new float[values.length];
        for (int i = 0; i < values.length; i++) {
            result[i] = (float) values[i];
        }
        return result;
    }
}
