package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Comparator;
import java.util.function.IntBinaryOperator;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** Built-in patches; the contract of the acceptance tests has the colors of most. */
class BuiltInPatchesTest {
    /** A quarter of the shortest wavelength: at grazing light and view a phase of pi between two samples. */
    private static final double COARSEST_PITCH = 380e-9 / 4;

    @ParameterizedTest
    @MethodSource("sunbeam.precompute.patch.builtin.BuiltInPatches#names")
    void isFineEnoughForVisibleLight(String name) {
        HeightMap patch = BuiltInPatches.generate(name);
        assertThat(patch.pitchX()).isLessThanOrEqualTo(COARSEST_PITCH);
        assertThat(patch.pitchY()).isLessThanOrEqualTo(COARSEST_PITCH);
        assertThat(Arrays.stream(patch.heights()).allMatch(Double::isFinite)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"sinusoid", "lattice", "disc", "bumps", "elaphe-like", "xenopeltis-like"})
    void tilesWithoutASeam(String name) {
        HeightMap patch = BuiltInPatches.generate(name);
        int columns = patch.columns();
        int rows = patch.rows();
        double[] across = IntStream.range(0, columns)
                .mapToDouble(c -> rmsStep(rows, i -> patch.at((c + 1) % columns, i) - patch.at(c, i)))
                .toArray();
        double[] down = IntStream.range(0, rows)
                .mapToDouble(r -> rmsStep(columns, i -> patch.at(i, (r + 1) % rows) - patch.at(i, r)))
                .toArray();
        // The sinusoid's steps beside the seam are equal but for rounding.
        for (double[] steps : new double[][] {across, down}) {
            double inside = Arrays.stream(steps, 0, steps.length - 1).max().orElseThrow();
            assertThat(steps[steps.length - 1]).isLessThanOrEqualTo(inside * (1 + 1e-9));
        }
    }

    private static double rmsStep(int count, IntToDoubleFunction step) {
        return Math.sqrt(IntStream.range(0, count)
                .mapToDouble(step)
                .map(value -> value * value)
                .average()
                .orElseThrow());
    }

    private static final double HALF_DEPTH = -55e-9;
    private static final int TRACKS = 32;
    private static final HeightMap DISC = BuiltInPatches.generate("disc");

    @Test
    void pitsAndLandsLast3To11Bits() {
        double bit = DISC.height() / 184;
        assertThat(bit).isBetween(277e-9, 324e-9); // 1.2 to 1.4 m/s at 4.3218 MHz
        int columns = DISC.columns() / TRACKS;
        for (int track = 0; track < TRACKS; track++) {
            for (int samples : runs(track * columns + columns / 2).toArray()) {
                double bits = samples * DISC.pitchY() / bit;
                // Both ends of a run are known to one sample of 50 nm, 0.18 bits.
                assertThat(bits).isBetween(3 - 0.2, 11 + 0.2);
                assertThat(Math.abs(bits - Math.round(bits))).isLessThan(0.2);
            }
        }
    }

    /** Lengths in samples of the pits and lands round the whole column. */
    private static IntStream runs(int column) {
        int[] edges = IntStream.range(0, DISC.rows())
                .filter(row -> isPit(column, row) != isPit(column, row - 1))
                .toArray();
        return IntStream.range(0, edges.length)
                .map(i -> Math.floorMod(edges[(i + 1) % edges.length] - edges[i], DISC.rows()));
    }

    private static boolean isPit(int column, int row) {
        return DISC.at(column, Math.floorMod(row, DISC.rows())) < HALF_DEPTH;
    }

    private static final Spectrum ELAPHE = new Spectrum(BuiltInPatches.generate("elaphe-like"));
    private static final Spectrum XENOPELTIS = new Spectrum(BuiltInPatches.generate("xenopeltis-like"));

    /** Gaps between fingers differ by 15 %, so that orders are some bins wide; rows are known to a bin or two. */
    @Test
    void fingersAndRowsAreAsFarApartAsOnTheSnakes() {
        assertPeriod(ELAPHE.byP((p, q) -> Math.abs(q) < 10), 40, 3, 1.03e-6, 0.06e-6);
        assertPeriod(ELAPHE.byQ((p, q) -> Math.abs(p) > 26), 14, 1, 3.1e-6, 0.3e-6);
        assertPeriod(XENOPELTIS.byP((p, q) -> true), 60, 3, 0.55e-6, 0.03e-6);
        assertPeriod(XENOPELTIS.byQ((p, q) -> Math.abs(p) < 30), 25, 1, 1.55e-6, 0.08e-6);
    }

    /** Of the strongest frequency from {@code first} on, smoothed over a window of bins; meters. */
    private static void assertPeriod(double[] powers, int first, int reach, double expected, double tolerance) {
        int best = IntStream.range(first, powers.length - reach)
                .boxed()
                .max(Comparator.comparingDouble(bin ->
                        Arrays.stream(powers, bin - reach, bin + reach + 1).sum()))
                .orElseThrow();
        assertThat(65e-6 / best).isCloseTo(expected, within(tolerance));
    }

    @Test
    void xenopeltisDiffractsMostlyAboutY() {
        double along = XENOPELTIS.meanSquare((p, q) -> isOrder(p, q) && Math.abs(q) < Math.abs(p));
        double across = XENOPELTIS.meanSquare((p, q) -> isOrder(p, q) && Math.abs(p) < Math.abs(q));
        // The scan: 2.9 times as much on the steep side of the diagonals.
        assertThat(across).isGreaterThan(2.5 * along);
        // The rows meander: their order is an arc, with most of its power off the axis (scan: 0.37 near it).
        double arc = XENOPELTIS.meanSquare((p, q) -> Math.abs(Math.abs(q) - 42) < 5 && Math.abs(p) < 40);
        double axis = XENOPELTIS.meanSquare((p, q) -> Math.abs(Math.abs(q) - 42) < 5 && Math.abs(p) < 5);
        assertThat(axis).isBetween(0.25 * arc, 0.5 * arc);
    }

    private static boolean isOrder(int p, int q) {
        double radius = Math.hypot(p, q);
        return radius >= 15 && radius < 80;
    }

    /** Power spectrum of a patch's heights without their mean, up to the finest that diffract light. */
    private record Spectrum(HeightSpectrum spectrum) {
        Spectrum(HeightMap patch) {
            this(HeightSpectrum.of(patch, HeightSpectrum.Edges.PERIODIC));
        }

        /** Selects bins by their signed numbers of periods across the patch, q upwards. */
        interface Bins {
            boolean contains(int p, int q);
        }

        private double[] sums(Bins bins, IntBinaryOperator index, int count) {
            double[] sums = new double[count];
            for (int q = spectrum.bandY().first(); q <= spectrum.bandY().last(); q++) {
                for (int p = spectrum.bandX().first(); p <= spectrum.bandX().last(); p++) {
                    if (bins.contains(p, q)) {
                        sums[index.applyAsInt(p, q)] += spectrum.at(p, q);
                    }
                }
            }
            return sums;
        }

        double meanSquare(Bins bins) {
            return sums(bins, (p, q) -> 0, 1)[0];
        }

        /** Mean squares of these bins by their absolute number of periods along x. */
        double[] byP(Bins bins) {
            return sums(bins, (p, q) -> Math.abs(p), spectrum.bandX().last() + 1);
        }

        /** Mean squares of these bins by their absolute number of periods along y. */
        double[] byQ(Bins bins) {
            return sums(bins, (p, q) -> Math.abs(q), spectrum.bandY().last() + 1);
        }
    }

    private static final double BUMP_WIDTH = 0.5e-6;
    private static final double BUMP_LENGTH = 1e-6;
    private static final double AREA = BUMP_WIDTH * BUMP_LENGTH;
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
                .mapToDouble(seed -> power(BuiltInPatches.bumps(SAMPLES, bumps, seed), WINDOW, phase, fx, fy))
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
                double shared = (BUMP_WIDTH - Math.abs(x)) * (BUMP_LENGTH - Math.abs(y));
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
