package sunbeam.precompute.fourier;

import java.util.Arrays;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;

/**
 * Any equally spaced band of frequencies of a sequence of any length, by Bluestein's algorithm over power-of-two
 * transforms (Bluestein 1970; Rabiner, Schafer, Rader 1969):
 *
 * <pre>X_m = sum_n x_n exp(+2 pi i n (start + m step)),  0 &lt;= n &lt; inputs,  0 &lt;= m &lt; outputs</pre>
 *
 * with n m = (n^2 + m^2 - (m - n)^2) / 2. No normalisation. Relative error about 1e-15 log2(length). Immutable and safe
 * for use by several threads; each call needs a {@link #workspace()} of its own.
 */
public final class ChirpZ {
    private final int inputs;
    private final int outputs;
    private final int padded;
    private final ComplexVector inputFactor;
    private final ComplexVector outputFactor;
    private final ComplexVector filterSpectrum;

    /**
     * @param inputs length of the sequence, at least 1
     * @param outputs number of frequencies, at least 1
     * @param startTurns first frequency, cycles per sample
     * @param stepTurns distance of frequencies, cycles per sample
     */
    public ChirpZ(int inputs, int outputs, double startTurns, double stepTurns) {
        if (inputs < 1 || outputs < 1) {
            throw new IllegalArgumentException("empty transform: " + inputs + " -> " + outputs);
        }
        this.inputs = inputs;
        this.outputs = outputs;
        this.padded = Math.max(2, ceilingPowerOfTwo(inputs + outputs - 1));
        this.inputFactor = ComplexVector.zeros(inputs);
        this.outputFactor = ComplexVector.zeros(outputs);
        this.filterSpectrum = ComplexVector.zeros(padded);
        for (int n = 0; n < inputs; n++) {
            setUnit(inputFactor, n, turns(n, startTurns) + halfSquareTurns(n, stepTurns));
        }
        for (int m = 0; m < outputs; m++) {
            setUnit(outputFactor, m, halfSquareTurns(m, stepTurns));
        }
        for (int n = 0; n < Math.max(inputs, outputs); n++) {
            double angle = -halfSquareTurns(n, stepTurns);
            if (n < outputs) {
                setUnit(filterSpectrum, n, angle);
            }
            if (n > 0 && n < inputs) {
                setUnit(filterSpectrum, padded - n, angle);
            }
        }
        forward(filterSpectrum);
    }

    private static int ceilingPowerOfTwo(int value) {
        return value <= 1 ? 1 : Integer.highestOneBit(value - 1) << 1;
    }

    // Phases are reduced to one turn before they meet sine and cosine, so that long sequences lose no digits.
    private static double turns(long n, double frequency) {
        double product = n * frequency;
        return product - Math.rint(product);
    }

    private static double halfSquareTurns(long n, double step) {
        double product = 0.5 * (n * n) * step;
        return product - Math.rint(product);
    }

    private static void setUnit(ComplexVector vector, int index, double turns) {
        vector.real()[index] = Math.cos(2 * Math.PI * turns);
        vector.imaginary()[index] = Math.sin(2 * Math.PI * turns);
    }

    private static void forward(ComplexVector data) {
        FastFourierTransformer.transformInPlace(
                new double[][] {data.real(), data.imaginary()}, DftNormalization.STANDARD, TransformType.FORWARD);
    }

    private static void inverse(ComplexVector data) {
        FastFourierTransformer.transformInPlace(
                new double[][] {data.real(), data.imaginary()}, DftNormalization.STANDARD, TransformType.INVERSE);
    }

    public int inputs() {
        return inputs;
    }

    public int outputs() {
        return outputs;
    }

    /** A work vector for {@link #transform}; its first {@link #inputs()} values take the sequence. */
    public ComplexVector workspace() {
        return ComplexVector.zeros(padded);
    }

    /**
     * Transforms in place: reads the first {@link #inputs()} values, leaves the result in the first
     * {@link #outputs()}; the rest is scratch.
     */
    public void transform(ComplexVector work) {
        if (work.length() != padded) {
            throw new IllegalArgumentException("workspace of " + padded + " needed, got " + work.length());
        }
        multiply(work, inputFactor, inputs);
        Arrays.fill(work.real(), inputs, padded, 0);
        Arrays.fill(work.imaginary(), inputs, padded, 0);
        forward(work);
        multiply(work, filterSpectrum, padded);
        inverse(work);
        multiply(work, outputFactor, outputs);
    }

    private static void multiply(ComplexVector target, ComplexVector factor, int count) {
        double[] re = target.real();
        double[] im = target.imaginary();
        double[] factorRe = factor.real();
        double[] factorIm = factor.imaginary();
        for (int i = 0; i < count; i++) {
            double real = re[i] * factorRe[i] - im[i] * factorIm[i];
            im[i] = re[i] * factorIm[i] + im[i] * factorRe[i];
            re[i] = real;
        }
    }
}
