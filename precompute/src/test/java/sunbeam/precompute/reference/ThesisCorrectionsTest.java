package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;

/** Corrections to the thesis that no other test shows; docs/theory.md lists them all. */
class ThesisCorrectionsTest {
    private static final double WAVELENGTH = 500e-9;
    private static final double ROUNDING = 1e-12;
    private static final CieTable CIE = CieTable.load();

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

    @Test
    void theGeometricSumOfNPlusOneReplicasEndsAtNPlusOne() {
        int replicas = 7;
        for (double phase = 0.1; phase < 6.2; phase += 0.37) {
            Complex sum = Complex.ZERO;
            for (int n = 0; n < replicas; n++) {
                sum = sum.add(turn(-phase * n));
            }
            // Eq. 2.62 with N + 1 = replicas in the numerator's exponent; with N one replica is missing.
            Complex closed = Complex.ONE.subtract(turn(-phase * replicas)).divide(Complex.ONE.subtract(turn(-phase)));
            assertThat(closed.subtract(sum).abs()).isLessThan(ROUNDING);
            // Method pq computes this real expression.
            double array = Math.sin(replicas * phase / 2) / Math.sin(phase / 2);
            assertThat(array * array).isCloseTo(squared(sum), within(ROUNDING * replicas * replicas));
        }
    }

    @Test
    void aProductOfComplexFactorsMixesTheirParts() {
        Complex first = new Complex(0.3, -1.2);
        Complex second = new Complex(0.7, 0.4);
        Complex product = first.multiply(second);
        // Eq. 2.73: p1 q2 + q1 p2.
        assertThat(product.getImaginary())
                .isCloseTo(
                        first.getReal() * second.getImaginary() + first.getImaginary() * second.getReal(),
                        within(ROUNDING));
        assertThat(squared(product)).isCloseTo(squared(first) * squared(second), within(ROUNDING));
    }

    /** Eq. 2.69 has q = (b c + a d) / (c^2 + d^2) for the quotient (a + i b) / (c + i d). */
    @Test
    void aQuotientsImaginaryPartHasADifference() {
        Complex first = new Complex(0.3, -1.2);
        Complex second = new Complex(0.7, 0.4);
        double difference = first.getImaginary() * second.getReal() - first.getReal() * second.getImaginary();
        assertThat(first.divide(second).getImaginary()).isCloseTo(difference / squared(second), within(ROUNDING));
    }

    /** Eq. 2.11 integrates f(t) g(t - x), which is f(t) times a constant; two Gaussians convolved have the sum of both variances. */
    @Test
    void aConvolutionIntegratesOverTheShift() {
        double t = 1.3;
        double step = 0.01;
        double sum = 0;
        for (double x = -10; x < 10; x += step) {
            sum += step * gauss(x, 0.6) * gauss(t - x, 0.8);
        }
        // The trapezoidal rule of a Gaussian is exact up to exp(-2 (pi 0.48 / 0.01)^2).
        assertThat(sum).isCloseTo(gauss(t, 1), within(ROUNDING));
    }

    private static double gauss(double x, double sigma) {
        return Math.exp(-x * x / (2 * sigma * sigma)) / (sigma * Math.sqrt(2 * Math.PI));
    }

    /** Draft 001, section 2.2.2, says 99.99 % of four deviations, which is the share of eight. */
    @Test
    void fourDeviationsOfTheWindowHold95Percent() {
        NormalDistribution window = new NormalDistribution();
        assertThat(window.probability(-2, 2)).isCloseTo(0.954, within(0.001));
        assertThat(window.probability(-4, 4)).isCloseTo(0.9999, within(0.0001));
    }

    /** Eq. 2.57 sums the squares of the terms n; the expansion of exp(-i k w h) adds up before it is squared. */
    @Test
    void termsAddUpBeforeTheyAreSquared() {
        double phase = 1.5 * Math.PI;
        Complex term = Complex.ONE;
        Complex sum = Complex.ZERO;
        double squares = 0;
        for (int n = 0; n < 30; n++) {
            sum = sum.add(term);
            squares += squared(term);
            term = term.multiply(new Complex(0, phase)).divide(n + 1.0);
        }
        assertThat(squared(sum)).isCloseTo(1, within(1e-9));
        assertThat(squares).isGreaterThan(100);
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

    /** Bins of random phase, as a rough surface has: one wavelength's speckle loses the power above, and errs by five times as much. */
    @Test
    void threeByThreeBinsOfSpeckleErrByAnEighthInTheMedian() {
        double sigma = CoherenceWindow.ofCoherenceLength(65e-6).sigmaFrequency() * 65e-6;
        Random random = new Random(3);
        double[] errors = new double[4000];
        for (int draw = 0; draw < errors.length; draw++) {
            double[] shift = {random.nextDouble(), random.nextDouble()};
            Complex all = Complex.ZERO;
            Complex near = Complex.ZERO;
            for (int x = -4; x <= 5; x++) {
                for (int y = -4; y <= 5; y++) {
                    double square = Math.pow(x - shift[0], 2) + Math.pow(y - shift[1], 2);
                    Complex bin = new Complex(random.nextGaussian(), random.nextGaussian())
                            .multiply(Math.exp(-square / (2 * sigma * sigma)));
                    all = all.add(bin);
                    near = Math.max(Math.abs(x), Math.abs(y)) <= 1 ? near.add(bin) : near;
                }
            }
            errors[draw] = Math.abs(squared(near) / squared(all) - 1);
        }
        Arrays.sort(errors);
        // The standard error of the median of 4000 is 0.004.
        assertThat(errors[errors.length / 2]).isCloseTo(0.126, within(0.012));
    }

    private static Complex turn(double angle) {
        return new Complex(Math.cos(angle), Math.sin(angle));
    }

    /** Section 5.1: steps of 10 nm and more cause artifacts. */
    @Test
    void coarseWavelengthStepsBringTheArtefactsAndFineOnesDoNot() {
        double coarsest = medianError(10e-9);
        double thesis = medianError(5e-9);

        // Expected 4e-1, 3e-2 and 9e-5 for the blazed grating at 10, 5 and 1 nm.
        assertThat(coarsest).isGreaterThan(0.1);
        assertThat(thesis).isLessThan(0.3 * coarsest);
        assertThat(medianError(1e-9)).isLessThan(1e-3);
    }

    /** Error of X, Y, Z of a blazed grating under sunlight anywhere in its plane, against steps of 0.05 nm. */
    private static double medianError(double step) {
        double[] errors = new double[36];
        for (int i = 0; i < errors.length; i++) {
            double u = 0.05 * (i + 1);
            double[] exact = xyz(u, 0.05e-9);
            double[] coarse = xyz(u, step);
            double difference = 0;
            double length = 0;
            for (int c = 0; c < 3; c++) {
                difference += Math.pow(coarse[c] - exact[c], 2);
                length += exact[c] * exact[c];
            }
            errors[i] = Math.sqrt(difference / length);
        }
        Arrays.sort(errors);
        return errors[errors.length / 2];
    }

    private static double[] xyz(double u, double step) {
        WavelengthNodes nodes = WavelengthNodes.uniform(CIE, step);
        double[] sum = new double[3];
        for (int i = 0; i < nodes.count(); i++) {
            double power = blazedPower(u, nodes.wavelengths()[i]);
            for (int c = 0; c < 3; c++) {
                sum[c] += power * nodes.weights()[i][c];
            }
        }
        return sum;
    }

    /** Orders 0 to 12 of a ramp of 250 nm, 2.5 um long, at w = -1.5: sinc^2 times the window's Gaussian. */
    private static double blazedPower(double u, double wavelength) {
        CoherenceWindow sunlight = CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);
        double power = 0;
        for (int order = 0; order <= 12; order++) {
            double offset = Math.PI * (-1.5 * 250e-9 / wavelength + order);
            double sinc = Math.abs(offset) < 1e-9 ? 1 : Math.sin(offset) / offset;
            double distance = (u / wavelength - order / 2.5e-6) / sunlight.sigmaFrequency();
            power += sinc * sinc * Math.exp(-distance * distance);
        }
        return power;
    }

    @Test
    void chordsOfTheColorTableLieAboveItsFlanks() {
        assertThat(worstChord(0.1)).as("where a function is bright").isBetween(1e-3, 2e-3);
        assertThat(worstChord(1e-3)).as("about the minimum of xbar at 503 nm").isBetween(0.01, 0.03);
    }

    /** Largest excess of chords where a function exceeds a share of its maximum. */
    private static double worstChord(double share) {
        double worst = 0;
        for (int c = 0; c < 3; c++) {
            double largest = 0;
            for (int nanometer = 380; nanometer <= 780; nanometer++) {
                largest = Math.max(largest, CIE.at(nanometer * 1e-9, c));
            }
            for (int nanometer = 381; nanometer < 778; nanometer++) {
                // Four whole nanometers within a 5 nm piece of D65, which has kinks.
                boolean withinPiece = nanometer % 5 >= 1 && nanometer % 5 <= 3;
                if (withinPiece && CIE.at(nanometer * 1e-9, c) > share * largest) {
                    worst = Math.max(worst, chordExcess(nanometer, c));
                }
            }
        }
        return worst;
    }

    /** Excess of the chord over the cubic through four neighbors, half a nanometer between, relative. */
    private static double chordExcess(int nanometer, int channel) {
        double[] value = new double[4];
        for (int i = 0; i < 4; i++) {
            value[i] = CIE.at((nanometer - 1 + i) * 1e-9, channel);
        }
        double chord = CIE.at((nanometer + 0.5) * 1e-9, channel);
        double cubic = (9 * (value[1] + value[2]) - value[0] - value[3]) / 16;
        return (chord - cubic) / cubic;
    }
}
