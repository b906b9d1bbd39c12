package sunbeam.precompute.table;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntConsumer;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform2d;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

/**
 * Transforms the terms T_n(h) of a patch into a {@link FourierTable}.
 *
 * @param progress receives the number of finished terms after each transform
 */
public record TableBuilder(PatchIdentity patch, HeightLevels heights, IntConsumer progress) {
    /** Returns the bins of all terms within the bands. */
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
            int term = n;
            ComplexVector bins = transform.transform(
                    rows(expansion, s -> expansion.realBasis(term, s), s -> expansion.imaginaryBasis(term, s)));
            real[n] = toFloat(bins.real());
            imaginary[n] = toFloat(bins.imaginary());
            progress.accept(n + 1);
        }
    }

    /** Transforms two real terms a, b at once, z = a + i b: A(f) = (Z(f) + Z*(-f)) / 2, B(f) = (Z(f) - Z*(-f)) / 2i. */
    private void transformPairs(Expansion expansion, Band bandX, Band bandY, float[][] real, float[][] imaginary) {
        Band symmetricX = bandX.symmetric();
        Band symmetricY = bandY.symmetric();
        BandTransform2d transform = new BandTransform2d(patch.columns(), patch.rows(), symmetricX, symmetricY);
        for (int n = 0; n < expansion.terms(); n += 2) {
            boolean pair = n + 1 < expansion.terms();
            int first = n;
            ComplexVector z = transform.transform(rows(
                    expansion, s -> expansion.realBasis(first, s), s -> pair ? expansion.realBasis(first + 1, s) : 0));
            for (int term = n; term <= (pair ? n + 1 : n); term++) {
                real[term] = new float[bandX.count() * bandY.count()];
                imaginary[term] = new float[bandX.count() * bandY.count()];
                separate(z, symmetricX, symmetricY, bandX, bandY, term == n, real[term], imaginary[term]);
            }
            progress.accept(pair ? n + 2 : n + 1);
        }
    }

    private static void separate(
            ComplexVector z,
            Band symmetricX,
            Band symmetricY,
            Band bandX,
            Band bandY,
            boolean first,
            float[] re,
            float[] im) {
        int last = z.length() - 1;
        int target = 0;
        for (int jy = bandY.first(); jy <= bandY.last(); jy++) {
            for (int jx = bandX.first(); jx <= bandX.last(); jx++, target++) {
                int at = (jy - symmetricY.first()) * symmetricX.count() + jx - symmetricX.first();
                double a = z.real()[at];
                double b = z.imaginary()[at];
                double mirroredA = z.real()[last - at];
                double mirroredB = z.imaginary()[last - at];
                re[target] = (float) (0.5 * (first ? a + mirroredA : b + mirroredB));
                im[target] = (float) (0.5 * (first ? b - mirroredB : mirroredA - a));
            }
        }
    }

    /** Returns the rows of a complex image: its real and imaginary parts are the given functions of the scaled height of each sample. */
    private BandTransform2d.RowSource rows(
            Expansion expansion, DoubleUnaryOperator real, DoubleUnaryOperator imaginary) {
        HeightScale scale = expansion.scale();
        int columns = patch.columns();
        if (heights.areTooManyToTabulate()) {
            HeightMap map = heights.map();
            return (row, realRow, imaginaryRow) -> {
                for (int column = 0; column < columns; column++) {
                    double scaled = scale.scaled(map.at(column, row));
                    realRow[column] = real.applyAsDouble(scaled);
                    imaginaryRow[column] = imaginary.applyAsDouble(scaled);
                }
            };
        }
        double[] realLevels = atLevels(scale, real);
        double[] imaginaryLevels = atLevels(scale, imaginary);
        int[] index = heights.index();
        return (row, realRow, imaginaryRow) -> {
            for (int column = 0, i = row * columns; column < columns; column++, i++) {
                realRow[column] = realLevels[index[i]];
                imaginaryRow[column] = imaginaryLevels[index[i]];
            }
        };
    }

    private double[] atLevels(HeightScale scale, DoubleUnaryOperator function) {
        double[] levels = heights.levels();
        double[] values = new double[levels.length];
        Arrays.parallelSetAll(values, i -> function.applyAsDouble(scale.scaled(levels[i])));
        return values;
    }

    private static float[] toFloat(double[] values) {
        float[] result = new float[values.length];
        for (int i = 0; i < values.length; i++) {
            result[i] = (float) values[i];
        }
        return result;
    }
}
