package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.expansion.LowRankExpansion;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.reference.ReplicaLight;

/** One period's interpolated spectrum against the exact sum over its samples. */
class PeriodSpectrumTest {
    private static final double WAVELENGTH = 500e-9;
    private static final double W = -1.6;
    // An error of the expansion of 1e-9 is below all measured errors.
    private static final double EXPANSION_TOLERANCE = 1e-9;

    // Rough, with odd and even sides: neighboring bins are independent.
    private final HeightMap map = Surfaces.random(37, 24, 100e-9, 300e-9, 5);
    private final HeightLevels heights = HeightLevels.of(map);
    private final ReplicaLight exact = new ReplicaLight(map, new Replicas(1, 1), CieTable.load());

    private double largestError(PeriodInterpolation interpolation, boolean onBins) {
        SpectrumReader reader = new SpectrumReader(interpolation);
        SplittableRandom random = new SplittableRandom(17);
        double largest = 0;
        for (int i = 0; i < 200; i++) {
            double binX = 8 * random.nextDouble() - 4;
            double binY = 6 * random.nextDouble() - 3;
            double u = (onBins ? Math.rint(binX) : binX) / map.width() * WAVELENGTH;
            double v = (onBins ? Math.rint(binY) : binY) / map.height() * WAVELENGTH;
            // Not unit vectors; the sum depends on (u, v, w) only.
            DirectionPair pair = new DirectionPair(new Direction(-u, -v, -W), new Direction(0, 0, 0));
            double amplitude = Math.sqrt(exact.power(pair, WAVELENGTH));
            largest = Math.max(largest, Math.abs(reader.amplitude(u / WAVELENGTH, v / WAVELENGTH) - amplitude));
        }
        return largest;
    }

    @Test
    void sincIsExactEverywhere() {
        // Amplitudes are at most 1. Seven Kaiser-Bessel taps at twofold oversampling leave an alias of 1e-7 at the
        // period's edge, less inside.
        assertThat(largestError(PeriodInterpolation.SINC, false)).isLessThan(1e-7);
    }

    @Test
    void linearIsExactOnTheBins() {
        // Double precision, 888 samples.
        assertThat(largestError(PeriodInterpolation.LINEAR, true)).isLessThan(1e-8);
    }

    /** The interpolation of shaders/method/pq.glsl in double precision. */
    private final class SpectrumReader {
        private final PeriodInterpolation interpolation;
        private final Band band = Band.of(-20, 20);
        private final ComplexVector sum;

        SpectrumReader(PeriodInterpolation interpolation) {
            this.interpolation = interpolation;
            HeightScale scale = HeightScale.midRange(heights);
            double zeta = scale.phase(WAVELENGTH, -W);
            LowRankExpansion expansion = LowRankExpansion.within(heights, scale, 0.5 * zeta, zeta, EXPANSION_TOLERANCE);
            PeriodSpectrum spectrum = new PeriodSpectrum(heights, expansion, band, band, interpolation);
            double[] coefficients = expansion.coefficients(zeta);
            sum = ComplexVector.zeros(band.count() * band.count());
            for (int n = 0; n < expansion.terms(); n++) {
                ComplexVector term = spectrum.term(n);
                for (int i = 0; i < sum.length(); i++) {
                    sum.real()[i] += coefficients[n] * term.real()[i];
                    sum.imaginary()[i] += coefficients[n] * term.imaginary()[i];
                }
            }
        }

        double amplitude(double fx, double fy) {
            double x = fx * interpolation.oversampling() * map.width() - band.first();
            double y = fy * interpolation.oversampling() * map.height() - band.first();
            double real = 0;
            double imaginary = 0;
            for (int row = 0; row < band.count(); row++) {
                for (int column = 0; column < band.count(); column++) {
                    double weight = interpolation.kernel(x - column) * interpolation.kernel(y - row);
                    int i = row * band.count() + column;
                    real += weight * sum.real()[i];
                    imaginary += weight * sum.imaginary()[i];
                }
            }
            return Math.hypot(real, imaginary);
        }
    }
}
