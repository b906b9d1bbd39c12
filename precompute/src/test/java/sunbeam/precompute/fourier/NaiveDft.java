package sunbeam.precompute.fourier;

/** Transforms by their definition, slow, to test the fast ones. */
final class NaiveDft {
    private NaiveDft() {}

    /** sum_n x_n exp(+2 pi i n f) for a frequency f in cycles per sample: real part, imaginary part. */
    static double[] at(ComplexVector x, int length, double frequency) {
        double real = 0;
        double imaginary = 0;
        for (int n = 0; n < length; n++) {
            double cosine = Math.cos(2 * Math.PI * n * frequency);
            double sine = Math.sin(2 * Math.PI * n * frequency);
            real += x.real()[n] * cosine - x.imaginary()[n] * sine;
            imaginary += x.real()[n] * sine + x.imaginary()[n] * cosine;
        }
        return new double[] {real, imaginary};
    }
}
