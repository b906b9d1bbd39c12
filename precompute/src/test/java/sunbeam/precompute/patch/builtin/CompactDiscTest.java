package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.HeightMap;

class CompactDiscTest {
    private static final double HALF_DEPTH = -55e-9;
    private static final int TRACKS = 32;
    private static HeightMap disc;

    @BeforeAll
    static void generate() {
        disc = BuiltInPatches.generate("disc");
    }

    @Test
    void tracksAre1600NanometersApart() {
        assertThat(disc.width() / TRACKS).isCloseTo(1.6e-6, within(1e-18));
        double[] orders = new Spectrum(disc).byP((p, q) -> q == 0);
        for (int p = 1; p < 2 * TRACKS; p++) {
            if (p != TRACKS) {
                // Tracks with different numbers of pits leave a little power at all frequencies.
                assertThat(orders[p]).isLessThan(orders[TRACKS] / 100);
            }
        }
    }

    @Test
    void pitsAre110NanometersDeep() {
        assertThat(disc.maximum()).isZero();
        assertThat(disc.relief()).isCloseTo(110e-9, within(1e-20));
    }

    @Test
    void pitsAndLandsLast3To11Bits() {
        double bit = disc.height() / 184;
        assertThat(bit).isBetween(277e-9, 324e-9); // 1.2 to 1.4 m/s at 4.3218 MHz
        for (int track = 0; track < TRACKS; track++) {
            for (int samples : runs(center(track))) {
                double bits = samples * disc.pitchY() / bit;
                // Both ends of a run are known to one sample of 50 nm, 0.18 bits.
                assertThat(bits).isBetween(3 - 0.2, 11 + 0.2);
                assertThat(Math.abs(bits - Math.round(bits))).isLessThan(0.2);
            }
        }
    }

    private static int center(int track) {
        return track * (disc.columns() / TRACKS) + disc.columns() / TRACKS / 2;
    }

    /** Lengths in samples of the pits and lands round the whole column. */
    private static List<Integer> runs(int column) {
        int start = 0;
        while (isPit(column, start) == isPit(column, start - 1)) {
            start++;
        }
        List<Integer> runs = new ArrayList<>();
        int length = 0;
        for (int i = 0; i < disc.rows(); i++) {
            length++;
            if (isPit(column, start + i) != isPit(column, start + i + 1)) {
                runs.add(length);
                length = 0;
            }
        }
        return runs;
    }

    private static boolean isPit(int column, int row) {
        return disc.at(column, Math.floorMod(row, disc.rows())) < HALF_DEPTH;
    }
}
