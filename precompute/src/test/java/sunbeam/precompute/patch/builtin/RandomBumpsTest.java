package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.builtin.BuiltInPatches.RandomBumps;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** Light of randomly placed bumps against its mean over all draws by statistics alone, without heights or Fourier transforms. */
class RandomBumpsTest {
    private static final double WIDTH = 0.5e-6;
    private static final double LENGTH = 1e-6;
    private static final double AREA = WIDTH * LENGTH;
    /** 8 um along each side: an eighth of the built-in patch. */
    private static final int SAMPLES = 128;

    private static final double PATCH_AREA = 8e-6 * 8e-6;
    /** Short relative to the patch, so that replicas do not interfere: their correlation is exp(-64). */
    private static final CoherenceWindow WINDOW = new CoherenceWindow(0.5e-6);

    private static final int DRAWS = 48;

    @ParameterizedTest
    @CsvSource({
        // frequencies in 1 / um; blue, green, and red light, at which a bump is half a wave: brightest
        "16, 0, 0, 450e-9", // in mirror direction
        "16, 0.7, 0.2, 450e-9",
        "16, 0.2, 0.7, 450e-9",
        "16, 1.3, 0.4, 550e-9",
        "16, 0.3, 1.5, 600e-9", // the second lobe across
        "64, 0.9, 0.3, 600e-9", // most bumps overlap
    })
    void meanOverDrawsIsThatOfShotNoise(int bumps, double fx, double fy, double wavelength) {
        double phase = 2 * Math.PI / wavelength * -2 * 150e-9;
        double expected = expectedPower(bumps, phase, fx * 1e6, fy * 1e6);
        // A power is a mean over 2 pi (8 um sigma_f)^2 = 41 bins of exponential statistics, of 48 draws: 2.3 %, four
        // times over; in the mirror direction there is less noise.
        assertThat(meanPower(bumps, phase, fx * 1e6, fy * 1e6)).isCloseTo(expected, within(0.09 * expected));
    }

    private static double meanPower(int bumps, double phase, double fx, double fy) {
        return LongStream.range(0, DRAWS)
                .parallel()
                .mapToDouble(seed -> power(RandomBumps.generate(SAMPLES, bumps, seed), WINDOW, phase, fx, fy))
                .average()
                .orElseThrow();
    }

    private static double power(HeightMap map, CoherenceWindow window, double phase, double fx, double fy) {
        double wavelength = 500e-9;
        ReferenceEvaluator reference = new ReferenceEvaluator(map, window, WindowOrigin.CORNER);
        double[][] p = reference.phases(phase / 150e-9 / (2 * Math.PI / wavelength), wavelength);
        return reference.powers(p[0], p[1], fx, fy).ensemble();
    }

    /** Fourier transform of the correlation of shot noise times that of the window, by sums over all lags within a bump. */
    private static double expectedPower(int bumps, double phase, double fx, double fy) {
        double sigma = WINDOW.sigmaMeters();
        double pitch = 62.5e-9;
        double mirror = correlation(bumps, phase, 0);
        double halo = 0;
        for (int i = -8; i <= 8; i++) {
            for (int j = -16; j <= 16; j++) {
                double x = i * pitch;
                double y = j * pitch;
                double shared = (WIDTH - Math.abs(x)) * (LENGTH - Math.abs(y));
                halo += (correlation(bumps, phase, shared) - mirror)
                        * Math.exp(-(x * x + y * y) / (4 * sigma * sigma))
                        * Math.cos(2 * Math.PI * (fx * x + fy * y));
            }
        }
        double turns = 2 * Math.PI * sigma * Math.hypot(fx, fy);
        return mirror * Math.exp(-turns * turns) + halo * pitch * pitch / (4 * Math.PI * sigma * sigma);
    }

    /** The mean of p(s) p*(s + r) over all draws. */
    private static double correlation(int bumps, double phase, double shared) {
        return Math.pow(1 - 2 * (1 - Math.cos(phase)) * (AREA - shared) / PATCH_AREA, bumps);
    }
}
