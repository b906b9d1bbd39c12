package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;

/** Corrections to the thesis that no other test shows; docs/theory.md lists them all. */
class ThesisCorrectionsTest {
    private static final double WAVELENGTH = 500e-9;

    /** The windowed sum over a row equals the sum over its DFT bins with no factor but 1. */
    @Test
    void theWindowedSpectrumIsTheSumOverNormalisedBinsWithoutAFactorOfPi() {
        int samples = 24;
        double pitch = 100e-9;
        CoherenceWindow window = new CoherenceWindow(1e-6);
        HeightMap map = Surfaces.random(samples, 1, pitch, 200e-9, 8);
        DirectionPair pair = DirectionPairs.seeing(12, 0.7e6, 0, WAVELENGTH);

        Complex sum = Complex.ZERO;
        for (int bin = -12; bin < 12; bin++) {
            double distance = (0.7e6 - bin / map.width()) / window.sigmaFrequency();
            sum = sum.add(dft(map, pair.w(), bin).multiply(Math.exp(-0.5 * distance * distance)));
        }

        double exact = new ReferenceEvaluator(map, window, WindowOrigin.CORNER).coherent(pair, WAVELENGTH);
        // Eq. 2.55 has a factor of pi^2; a DFT without 1 / N one of 24^2. The next repetition of the spectrum, 3 um^-1
        // away, has e^-170.
        assertThat(squared(sum)).isCloseTo(exact, within(1e-9 * exact));
    }

    /** The thesis has [0, 1]; 1 is a mirror along the normal, and a mirror near the horizon is brighter. */
    @Test
    void theRelativeRadianceOfAMirrorIsNoShareOfTheLight() {
        DirectionPair mirror = new DirectionPair(Direction.ofDegrees(85, 0), Direction.ofDegrees(85, 180));

        // R(85) / R(0) = 1 + 24 (1 - cos 85)^5 = 16.22; (1 + cos 170)^2 / (4 cos(85)^3) = 0.0872 = cos 85; the mask is
        // 1.
        double expected = (1 + 24 * Math.pow(1 - Math.cos(Math.toRadians(85)), 5)) * Math.cos(Math.toRadians(85));
        assertThat(Gain.relativeRadiance(mirror))
                .isCloseTo(expected, within(1e-9))
                .isCloseTo(1.41, within(0.05));
    }

    /** F_j with 1 / N and e^{+i}. */
    private static Complex dft(HeightMap map, double w, int bin) {
        int samples = map.columns();
        Complex sum = Complex.ZERO;
        for (int column = 0; column < samples; column++) {
            double phase = 2 * Math.PI * (w * map.at(column, 0) / WAVELENGTH + (double) bin * column / samples);
            sum = sum.add(new Complex(Math.cos(phase), Math.sin(phase)));
        }
        return sum.divide(samples);
    }

    private static double squared(Complex value) {
        return value.getReal() * value.getReal() + value.getImaginary() * value.getImaginary();
    }

    /** Of a patch as wide as the coherence length: what the floor-anchored 3 x 3 bins of the shader leave out. */
    @Test
    void threeByThreeBinsMissAFortiethOfThePowerAndASixthOfTheAmplitude() {
        double sigma = CoherenceWindow.ofCoherenceLength(65e-6).sigmaFrequency() * 65e-6;
        double all = 0;
        double near = 0;
        double worst = 1;
        int steps = 1000;
        for (int step = 0; step < steps; step++) {
            double shift = (step + 0.5) / steps;
            double[] weights = new double[17];
            Arrays.setAll(weights, i -> Math.exp(-Math.pow((i - 8 - shift) / sigma, 2)));
            double here = Arrays.stream(weights).sum();
            double inside = weights[7] + weights[8] + weights[9];
            worst = Math.min(worst, inside / here);
            all += here;
            near += inside;
        }
        double missed = 1 - near / all * (near / all);
        assertThat(missed).isCloseTo(0.026, within(0.001));
        assertThat(Math.sqrt(missed)).isCloseTo(0.16, within(0.005));
        assertThat(1 - worst * worst).isCloseTo(0.14, within(0.005));
    }
}
