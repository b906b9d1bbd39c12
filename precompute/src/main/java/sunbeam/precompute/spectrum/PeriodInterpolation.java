package sunbeam.precompute.spectrum;

import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.spectrum.InterpolationDesign.KaiserBessel;

/**
 * Interpolation between the DFT bins of one period with sharp edges (thesis section 3.5), p_n being one of the N samples, at x_n:
 *
 * <pre>P_1(f) = 1/N sum_n p_n exp(2 pi i f x_n), x = 0 in the middle of the period</pre>
 */
public enum PeriodInterpolation {
    /**
     * The DFT's own interpolation, sum_j P_1(f_j) sin(pi (f - f_j) L) / (N sin(pi (f - f_j) pitch)) for a period of length L. A truncated
     * kernel would lose the specular order's tails, which outshine the rest of a rough patch; so the period is padded with zeros to twice
     * its length, and seven taps of a Kaiser-Bessel kernel, whose transform is divided out (Jackson et al. 1991), interpolate. Error below
     * 1e-7 of the largest amplitude, as measured.
     */
    SINC(2, 7),
    /** Linear interpolation between neighboring bins; exact only on the bins. */
    LINEAR(1, 2),
    /**
     * The thesis's interpolation over the bin below and its eight neighbors, weighted by sin(pi r) / (pi r) of their distance r in bins.
     * Phases refer to the period's corner and turn by pi from bin to bin.
     */
    RING(1, 3);

    private final int oversampling;
    private final int taps;

    PeriodInterpolation(int oversampling, int taps) {
        this.oversampling = oversampling;
        this.taps = taps;
    }

    public int oversampling() {
        return oversampling;
    }

    public int taps() {
        return taps;
    }

    public int margin() {
        // One more, because float32 may round a frequency into the next sample.
        return taps / 2 + 1;
    }

    public double kernel(double distance) {
        return switch (this) {
            case SINC -> kaiserBessel().value(distance);
            case LINEAR -> Math.max(0, 1 - Math.abs(distance));
            case RING -> throw new IllegalStateException("no kernel along one axis");
        };
    }

    /** Returns the factors that undo the kernel's attenuation at each of a period's samples. */
    private double[] corrections(int count) {
        return IntStream.range(0, count)
                .mapToDouble(i -> (i - PeriodSpectrum.middle(count)) / count)
                .map(place -> this == SINC ? 1 / kaiserBessel().transform(place / oversampling) : 1)
                .toArray();
    }

    // The first zero of the transform lies at the nearest alias of the period's edge, 1 - 1 / (2 oversampling).
    private KaiserBessel kaiserBessel() {
        double alias = Math.PI * taps * (1 - 0.5 / oversampling);
        return new KaiserBessel(taps, Math.sqrt(alias * alias - Math.PI * Math.PI));
    }

    /**
     * DFT of the terms T_n of one period with sharp edges, at samples that {@link PeriodInterpolation} interpolates. Sample j along x has the
     * frequency j / (oversampling * width). Phases refer to the period's middle, so that neighboring samples differ as little as possible; for
     * {@link PeriodInterpolation#RING} to the corner, as in the thesis.
     */
    public record PeriodSpectrum(
            HeightMap heights,
            Expansion expansion,
            Band bandX,
            Band bandY,
            PeriodInterpolation interpolation,
            BandTransform2d transform) {
        public PeriodSpectrum(
                HeightMap heights, Expansion expansion, Band bandX, Band bandY, PeriodInterpolation interpolation) {
            this(
                    heights,
                    expansion,
                    bandX,
                    bandY,
                    interpolation,
                    new BandTransform2d(
                            interpolation.oversampling * heights.columns(),
                            interpolation.oversampling * heights.rows(),
                            bandX,
                            bandY));
        }

        private static double middle(int count) {
            return 0.5 * (count - 1);
        }

        /** Returns one term times {@code expansion.kind().turn(n)}, in rows of ascending y samples. Runs on all cores. */
        public ComplexVector term(int n) {
            double[] correctionX = interpolation.corrections(heights.columns());
            double[] correctionY = interpolation.corrections(heights.rows());
            BandTransform2d.RowSource rows = FourierTable.rows(
                    heights, expansion.scale(), s -> expansion.realBasis(n, s), s -> expansion.imaginaryBasis(n, s));
            ComplexVector term = transform.transform((row, real, imaginary) -> {
                if (row < correctionY.length) {
                    rows.fill(row, real, imaginary);
                    for (int column = 0; column < correctionX.length; column++) {
                        double factor = correctionX[column] * correctionY[row];
                        real[column] *= factor;
                        imaginary[column] *= factor;
                    }
                }
            });
            turn(term, expansion.kind().turn(n));
            return term;
        }

        /** Turns phases to the middle; oversampling squared, because the DFT divides by the number of padded samples. */
        private void turn(ComplexVector samples, Complex turn) {
            double padding = interpolation.oversampling() * interpolation.oversampling();
            double turns = interpolation == PeriodInterpolation.RING ? 0 : 1.0 / interpolation.oversampling();
            double turnsX = -turns * middle(heights.columns()) / heights.columns();
            // Rows run downwards, y upwards.
            double turnsY = turns * middle(heights.rows()) / heights.rows();
            for (int i = 0; i < samples.length(); i++) {
                int jx = bandX.first() + i % bandX.count();
                int jy = bandY.first() + i / bandX.count();
                double angle = 2 * Math.PI * (jx * turnsX + jy * turnsY) + turn.getArgument();
                double cosine = padding * Math.cos(angle);
                double sine = padding * Math.sin(angle);
                double real = samples.real()[i];
                double imaginary = samples.imaginary()[i];
                samples.real()[i] = real * cosine - imaginary * sine;
                samples.imaginary()[i] = real * sine + imaginary * cosine;
            }
        }
    }
}
