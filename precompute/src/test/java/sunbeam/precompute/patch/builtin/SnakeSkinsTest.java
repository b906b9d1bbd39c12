package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.HeightMap;

class SnakeSkinsTest {
    private static HeightMap elaphe;
    private static HeightMap xenopeltis;
    private static Spectrum elapheSpectrum;
    private static Spectrum xenopeltisSpectrum;

    @BeforeAll
    static void generate() {
        elaphe = BuiltInPatches.generate("elaphe-like");
        xenopeltis = BuiltInPatches.generate("xenopeltis-like");
        elapheSpectrum = new Spectrum(elaphe);
        xenopeltisSpectrum = new Spectrum(xenopeltis);
    }

    /** Gaps between fingers differ by 15 %, so that orders are some bins wide; rows are known to a bin or two. */
    @Test
    void fingersAndRowsAreAsFarApartAsOnTheSnakes() {
        double[][] elaphePowers = {
            elapheSpectrum.byP((p, q) -> Math.abs(q) < 10), elapheSpectrum.byQ((p, q) -> Math.abs(p) > 26)
        };
        assertThat(dominantPeriod(elaphePowers[0], 40, 3)).isCloseTo(1.03e-6, within(0.06e-6));
        assertThat(dominantPeriod(elaphePowers[1], 14, 1)).isCloseTo(3.1e-6, within(0.3e-6));
        double[][] xenopeltisPowers = {
            xenopeltisSpectrum.byP((p, q) -> true), xenopeltisSpectrum.byQ((p, q) -> Math.abs(p) < 30)
        };
        assertThat(dominantPeriod(xenopeltisPowers[0], 60, 3)).isCloseTo(0.55e-6, within(0.03e-6));
        assertThat(dominantPeriod(xenopeltisPowers[1], 25, 1)).isCloseTo(1.55e-6, within(0.08e-6));
    }

    /** Period in meters of the strongest frequency from {@code first} on, smoothed over a window of bins. */
    private static double dominantPeriod(double[] powers, int first, int reach) {
        int best = first;
        double most = 0;
        for (int bin = first; bin + reach < powers.length; bin++) {
            double power = 0;
            for (int i = bin - reach; i <= bin + reach; i++) {
                power += powers[i];
            }
            if (power > most) {
                most = power;
                best = bin;
            }
        }
        return 65e-6 / best;
    }

    @Test
    void elapheDiffractsAlongXOnly() {
        // Periods from 0.8 to 4.3 um, within 15 degrees of either axis; the scan has 30 times as much along x.
        double along = elapheSpectrum.meanSquare((p, q) -> isOrder(p, q) && Math.abs(q) < 0.27 * Math.abs(p));
        double across = elapheSpectrum.meanSquare((p, q) -> isOrder(p, q) && Math.abs(p) < 0.27 * Math.abs(q));
        assertThat(along).isGreaterThan(15 * across);
    }

    @Test
    void xenopeltisDiffractsMostlyAboutY() {
        double along = xenopeltisSpectrum.meanSquare((p, q) -> isOrder(p, q) && Math.abs(q) < Math.abs(p));
        double across = xenopeltisSpectrum.meanSquare((p, q) -> isOrder(p, q) && Math.abs(p) < Math.abs(q));
        // The scan: 2.9 times as much on the steep side of the diagonals.
        assertThat(across).isGreaterThan(2.5 * along);
        // The rows meander: their order is an arc, with most of its power off the axis (scan: 0.37 near it).
        double arc = xenopeltisSpectrum.meanSquare((p, q) -> Math.abs(Math.abs(q) - 42) < 5 && Math.abs(p) < 40);
        double axis = xenopeltisSpectrum.meanSquare((p, q) -> Math.abs(Math.abs(q) - 42) < 5 && Math.abs(p) < 5);
        assertThat(axis).isBetween(0.25 * arc, 0.5 * arc);
    }

    private static boolean isOrder(int p, int q) {
        double radius = Math.hypot(p, q);
        return radius >= 15 && radius < 80;
    }
}
