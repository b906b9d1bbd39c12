package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.prepare.HeightField;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.setting.Choices;

class FaultLinesTest {
    private static final int SIDE = 64;

    private static HeightField stopped(int row, double jump) {
        SplittableRandom random = new SplittableRandom(1);
        double[] heights = new double[SIDE * SIDE];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = 1e-9 * random.nextGaussian() + (i / SIDE >= SIDE / 4 ? jump : 0);
        }
        Arrays.fill(heights, row * SIDE, heights.length, 0);
        return new HeightField(SIDE, SIDE, 1e-7, 1e-7, heights);
    }

    @Test
    void aSoundScanHasNoLine() {
        FaultLines lines = FaultLines.of(stopped(SIDE, 0), Choices.none(), Levelling.PLANE);
        assertThat(lines.each()).isEmpty();
        assertThat(lines.together()).isEmpty();
    }

    @Test
    void eachFaultNamesWhatHelps() {
        FaultLines lines = FaultLines.of(stopped(48, 1e-7), Choices.none(), Levelling.PLANE);
        assertThat(lines.each()).hasSize(2);
        assertThat(lines.each().get(0).line()).endsWith("crop 0:6.4um,1.6um:6.4um leaves them out");
        assertThat(lines.each().get(1).line()).endsWith("level median-rows takes that away");
        assertThat(lines.together().orElseThrow()).doesNotContain("\n").contains("49 to 64", "between rows 16 and 17");
    }

    /** What levelling has taken away is no fault of what is left. */
    @Test
    void whatIsMendedIsNotTold() {
        FaultLines lines = FaultLines.of(stopped(48, 1e-7), Choices.none(), Levelling.MEDIAN_ROWS);
        assertThat(lines.each()).singleElement().asString().contains("49 to 64");
    }
}
