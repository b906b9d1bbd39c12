package sunbeam.precompute.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.prepare.HeightField;

/** Rows of trace and retrace in turn, and sound surfaces that might be taken for them. */
class AlternateRowsTest {
    private static final int COLUMNS = 150;
    private static final int ROWS = 101;
    private static final double PITCH = 80e-9;

    @FunctionalInterface
    private interface Turns {
        double at(double column, int row);
    }

    /** Ridges where turns of a wave are less than half, tilted, with noise. */
    private static List<ScanFault> faults(Turns turns, double noise) {
        SplittableRandom random = new SplittableRandom(5);
        double[] heights = new double[COLUMNS * ROWS];
        for (int i = 0; i < heights.length; i++) {
            double turn = turns.at(i % COLUMNS, i / COLUMNS);
            heights[i] =
                    (turn - Math.floor(turn) < 0.5 ? 40e-9 : 0) + 1e-9 * (i % COLUMNS) + noise * random.nextGaussian();
        }
        return ScanFaults.in(new HeightField(COLUMNS, ROWS, PITCH, PITCH, heights), Optional.empty());
    }

    private static double wave(double column, double row, double samples, double degrees) {
        double angle = Math.toRadians(degrees);
        return (column * Math.cos(angle) - row * Math.sin(angle)) / samples;
    }

    /** Such a scan was told a period of 189.25 +- 0.1 nm, 2.3 samples, in place of 658 nm. */
    @ParameterizedTest
    @CsvSource({"0.05, 20", "0.1, -60", "0.25, 0", "0.4, 35", "0.45, 75", "1.3, -10"})
    void everySecondRowAsideIsTold(double periods, double degrees) {
        double aside = periods * 8 / Math.cos(Math.toRadians(degrees));
        List<ScanFault> faults = faults((x, row) -> wave(x + (row % 2) * aside, row, 8, degrees), 4e-9);
        assertThat(faults).extracting(ScanFault::words).containsExactly(AlternateRows.WORDS);
        assertThat(faults.get(0).unmeasured()).isEqualTo(1);
    }

    /** Also of few samples a period, whose rows differ from the next by half of a period, and walls that samples round. */
    @ParameterizedTest
    @CsvSource({"8, 0", "8, 26.565", "7, 45", "9.3, 80", "2.3, 80", "2.1, 60", "3, -45"})
    void aGratingIsSound(double samples, double degrees) {
        assertThat(faults((x, row) -> wave(x, row, samples, degrees), 4e-9)).isEmpty();
    }

    /** Rows that each jitter by themselves, or by noise ten times as high as the lines. */
    @ParameterizedTest
    @ValueSource(doubles = {4e-9, 400e-9})
    void jitterAndNoiseAreNotAlternate(double noise) {
        double[] aside = new SplittableRandom(6).doubles(ROWS, -2, 2).toArray();
        assertThat(faults((x, row) -> wave(x + aside[row], row, 8, 30), noise))
                .extracting(ScanFault::words)
                .doesNotContain(AlternateRows.WORDS);
    }

    @Test
    void aPictureThatWasStretchedIsNotShifted() {
        assertThat(faults((x, row) -> wave(x, 2 * (row / 2), 8, 40), 0)).isEmpty();
    }
}
