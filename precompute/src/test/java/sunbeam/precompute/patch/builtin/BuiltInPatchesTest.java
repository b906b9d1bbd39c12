package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.IntBinaryOperator;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.optics.HeightMap;

class BuiltInPatchesTest {
    /** A quarter of the shortest wavelength: at grazing light and view a phase of pi between two samples. */
    private static final double COARSEST_PITCH = 380e-9 / 4;

    static Stream<String> names() {
        return BuiltInPatches.names().stream();
    }

    @ParameterizedTest
    @MethodSource("names")
    void isFineEnoughForVisibleLight(String name) {
        HeightMap patch = BuiltInPatches.generate(name);
        assertThat(patch.pitchX()).isLessThanOrEqualTo(COARSEST_PITCH);
        assertThat(patch.pitchY()).isLessThanOrEqualTo(COARSEST_PITCH);
        assertThat(Arrays.stream(patch.heights()).allMatch(Double::isFinite)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"sinusoid", "disc", "bumps", "elaphe-like", "xenopeltis-like"})
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

    /** Rounding of sums over a few thousand heights, in square meters against mean squares of 1e-15. */
    private static final double ROUNDING = 1e-26;

    @Test
    void blazeRisesTowardsPlusXOverOnePeriod() {
        HeightMap blaze = BuiltInPatches.generate("blaze");
        assertThat(blaze.width()).isCloseTo(2.5e-6, within(1e-18));
        double step = 250e-9 / blaze.columns();
        for (int i = 0; i < blaze.heights().length; i++) {
            // Equal steps, from the middle of the first on, but for rounding.
            assertThat(blaze.heights()[i]).isCloseTo((i % blaze.columns() + 0.5) * step, within(1e-20));
        }
        // Mid-interval samples miss half a step at either end.
        assertThat(blaze.relief()).isCloseTo(250e-9 - step, within(1e-20));
    }

    @Test
    void sinusoidHasOneFrequencyOnly() {
        HeightMap sinusoid = BuiltInPatches.generate("sinusoid");
        Spectrum spectrum = new Spectrum(sinusoid);
        double amplitude = 100e-9;
        assertThat(spectrum.meanSquare((p, q) -> Math.abs(p) == 1 && q == 0))
                .isCloseTo(amplitude * amplitude / 2, within(ROUNDING));
        assertThat(spectrum.meanSquare((p, q) -> Math.abs(p) != 1 || q != 0)).isLessThan(ROUNDING);
    }

    @Test
    void lamellarHasTwoHeightsAndNoEvenOrders() {
        HeightMap lamellar = BuiltInPatches.generate("lamellar");
        assertThat(lamellar.heights()).containsOnly(0, 137.5e-9);
        long ridge = IntStream.range(0, lamellar.columns())
                .filter(column -> lamellar.at(column, 0) > 0)
                .count();
        assertThat(ridge).isEqualTo(lamellar.columns() / 2);
        assertThat(new Spectrum(lamellar).meanSquare((p, q) -> p % 2 == 0)).isLessThan(ROUNDING);
    }

    private static final double HALF_DEPTH = -55e-9;
    private static final int TRACKS = 32;
    private static final HeightMap DISC = BuiltInPatches.generate("disc");

    @Test
    void tracksAre1600NanometersApartAndPits110Deep() {
        assertThat(DISC.width() / TRACKS).isCloseTo(1.6e-6, within(1e-18));
        assertThat(DISC.maximum()).isZero();
        assertThat(DISC.relief()).isCloseTo(110e-9, within(1e-20));
        double[] orders = new Spectrum(DISC).byP((p, q) -> q == 0);
        double track = orders[TRACKS];
        orders[TRACKS] = 0;
        // Tracks with different numbers of pits leave a little power at all frequencies.
        assertThat(Arrays.stream(orders, 1, 2 * TRACKS).max().orElseThrow()).isLessThan(track / 100);
    }

    @Test
    void pitsAndLandsLast3To11Bits() {
        double bit = DISC.height() / 184;
        assertThat(bit).isBetween(277e-9, 324e-9); // 1.2 to 1.4 m/s at 4.3218 MHz
        for (int track = 0; track < TRACKS; track++) {
            for (int samples : runs(center(track))) {
                double bits = samples * DISC.pitchY() / bit;
                // Both ends of a run are known to one sample of 50 nm, 0.18 bits.
                assertThat(bits).isBetween(3 - 0.2, 11 + 0.2);
                assertThat(Math.abs(bits - Math.round(bits))).isLessThan(0.2);
            }
        }
    }

    private static int center(int track) {
        return track * (DISC.columns() / TRACKS) + DISC.columns() / TRACKS / 2;
    }

    /** Lengths in samples of the pits and lands round the whole column. */
    private static List<Integer> runs(int column) {
        int start = 0;
        while (isPit(column, start) == isPit(column, start - 1)) {
            start++;
        }
        List<Integer> runs = new ArrayList<>();
        int length = 0;
        for (int i = 0; i < DISC.rows(); i++) {
            length++;
            if (isPit(column, start + i) != isPit(column, start + i + 1)) {
                runs.add(length);
                length = 0;
            }
        }
        return runs;
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
    void elapheDiffractsAlongXOnly() {
        // Periods from 0.8 to 4.3 um, within 15 degrees of either axis; the scan has 30 times as much along x.
        double along = ELAPHE.meanSquare((p, q) -> isOrder(p, q) && Math.abs(q) < 0.27 * Math.abs(p));
        double across = ELAPHE.meanSquare((p, q) -> isOrder(p, q) && Math.abs(p) < 0.27 * Math.abs(q));
        assertThat(along).isGreaterThan(15 * across);
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
}
