package sunbeam.app.commands.color;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.PrincipalDirection;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.Patch;

class LevellingAdviceTest {
    private static List<String> advice(double offset, Patch.Repetition repetition) {
        SplittableRandom random = new SplittableRandom(3);
        double[] offsets = random.doubles(128, -1, 1).toArray();
        double[] heights = new double[128 * 128];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = 10e-9 * Math.sin(2 * Math.PI * (i % 128) / 11.0)
                    + 1e-9 * random.nextGaussian()
                    + offset * offsets[i / 128];
        }
        HeightMap map = new HeightMap(128, 128, 100e-9, 100e-9, heights);
        List<String> none = List.of();
        Patch patch = new Patch("scan", map, map, "made up", none, none, none, List.of(), Optional.empty(), repetition);
        return LevellingAdvice.of(patch, PrincipalDirection.of(map));
    }

    @Test
    void rowsThatJumpAreTold() {
        assertThat(advice(60e-9, Patch.Repetition.NONE))
                .hasSize(2)
                .anySatisfy(line -> assertThat(line)
                        .startsWith("as the scan is, it is looked at along 90 +- ")
                        .contains("with --level median-rows its direction of most colour is at 0 +- "))
                .anySatisfy(line -> assertThat(line).contains("but --level median-rows shows one of about 1.1 um"));
    }

    @Test
    void aSoundScanAndAPeriodAreLeftAlone() {
        assertThat(advice(0, Patch.Repetition.NONE)).isEmpty();
        assertThat(advice(60e-9, Patch.Repetition.PERIODIC)).isEmpty();
    }
}
