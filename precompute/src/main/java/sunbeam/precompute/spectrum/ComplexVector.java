package sunbeam.precompute.spectrum;

/** Vector of complex numbers, whose two arrays of equal length are not copied, since transforms work in place. */
public record ComplexVector(double[] real, double[] imaginary) {
    public static ComplexVector zeros(int length) {
        return new ComplexVector(new double[length], new double[length]);
    }

    public int length() {
        return real.length;
    }
}
