package sunbeam.precompute.spectrum;

import java.util.Arrays;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform2d;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;

/**
 * DFT of the terms T_n of one period with sharp edges, at samples that {@link PeriodInterpolation} interpolates. Sample j along x has the
 * frequency j / (oversampling * width). Phases refer to the period's middle, so that neighboring samples differ as little as possible; for
 * {@link PeriodInterpolation#RING} to the corner, as in the thesis.
 */
public final class PeriodSpectrum {
    private final HeightMap map;
    private final HeightLevels heights;
    private final Expansion expansion;
    private final PeriodInterpolation interpolation;
    private final Band bandX;
    private final Band bandY;
    private final BandTransform2d transform;
    private final double[] correctionX;
    private final double[] correctionY;

    /** @param bandX samples along x: those of visible directions and {@link PeriodInterpolation#margin()} more on each side */
    public PeriodSpectrum(
            HeightMap map,
            HeightLevels heights,
            Expansion expansion,
            Band bandX,
            Band bandY,
            PeriodInterpolation interpolation) {
        this.map = map;
        this.heights = heights;
        this.expansion = expansion;
        this.interpolation = interpolation;
        this.bandX = bandX;
        this.bandY = bandY;
        int samples = interpolation.oversampling();
        this.transform = new BandTransform2d(samples * map.columns(), samples * map.rows(), bandX, bandY);
        this.correctionX = corrections(map.columns());
        this.correctionY = corrections(map.rows());
    }

    private double[] corrections(int count) {
        double[] result = new double[count];
        Arrays.setAll(result, i -> interpolation.correction((i - middle(count)) / count));
        return result;
    }

    private static double middle(int count) {
        return 0.5 * (count - 1);
    }

    /** Returns one term times {@code expansion.kind().turn(n)}, in rows of ascending y samples. Runs on all cores. */
    public ComplexVector term(int n) {
        int[] index = heights.index();
        Complex[] values = new Complex[heights.count()];
        Complex turn = expansion.kind().turn(n);
        for (int i = 0; i < values.length; i++) {
            values[i] = expansion
                    .basis(n, expansion.scale().scaled(heights.levels()[i]))
                    .multiply(turn);
        }
        ComplexVector result = transform.transform((row, real, imaginary) -> fill(values, index, row, real, imaginary));
        if (interpolation != PeriodInterpolation.RING) {
            turnToMiddle(result);
        }
        return result;
    }

    // The zeros of the padding must be written: the work vector may hold another row.
    private void fill(Complex[] values, int[] index, int row, double[] real, double[] imaginary) {
        int columns = map.columns();
        int padded = interpolation.oversampling() * columns;
        for (int column = 0; column < padded; column++) {
            boolean inside = row < map.rows() && column < columns;
            Complex value = inside ? values[index[row * columns + column]] : Complex.ZERO;
            double factor = inside ? correctionX[column] * correctionY[row] : 0;
            real[column] = factor * value.getReal();
            imaginary[column] = factor * value.getImaginary();
        }
    }

    /** Also multiplies by the oversampling squared, because the DFT divides by the number of padded samples. */
    private void turnToMiddle(ComplexVector samples) {
        double padding = interpolation.oversampling() * interpolation.oversampling();
        double turnsX = -middle(map.columns()) / (interpolation.oversampling() * map.columns());
        // Rows run downwards, y upwards.
        double turnsY = middle(map.rows()) / (interpolation.oversampling() * map.rows());
        for (int i = 0; i < samples.length(); i++) {
            int jx = bandX.first() + i % bandX.count();
            int jy = bandY.first() + i / bandX.count();
            double angle = 2 * Math.PI * (jx * turnsX + jy * turnsY);
            double cosine = padding * Math.cos(angle);
            double sine = padding * Math.sin(angle);
            double real = samples.real()[i];
            double imaginary = samples.imaginary()[i];
            samples.real()[i] = real * cosine - imaginary * sine;
            samples.imaginary()[i] = real * sine + imaginary * cosine;
        }
    }
}
