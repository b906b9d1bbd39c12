package sunbeam.app.cli.compare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.CieLab;

class HueComparisonTest {
    private static final int COUNT = 2000;

    private static CieLab color(double hueDegrees, double chroma) {
        double hue = Math.toRadians(hueDegrees);
        return new CieLab(50, chroma * Math.cos(hue), chroma * Math.sin(hue));
    }

    /** The second hues are the first, turned by 25 degrees with errors of 3 degrees. */
    @Test
    void hueThatIsTurnedIsCorrelatedAndToldByHowMuch() {
        Random random = new Random(1);
        double[] hues = random.doubles(COUNT, 0, 180).toArray();
        List<CieLab> first =
                IntStream.range(0, COUNT).mapToObj(i -> color(hues[i], 40)).toList();
        List<CieLab> second = IntStream.range(0, COUNT)
                .mapToObj(i -> color(hues[i] + 25 + 3 * random.nextGaussian(), 20))
                .toList();
        PhotoComparison.HueComparison hue = PhotoComparison.HueComparison.of(first, second);
        // The mean of 2000 errors of 3 degrees has a standard error of 0.07.
        assertThat(hue.turnDegrees()).isCloseTo(25, within(0.3));
        assertThat(hue.correlation()).isGreaterThan(0.99);
        assertThat(IntStream.range(0, 18).mapToDouble(i -> hue.first()[i]).sum())
                .isCloseTo(1, within(1e-9));
    }

    @Test
    void huesByChanceAreNotCorrelatedAndGraysHaveNone() {
        Random random = new Random(2);
        List<CieLab> first =
                random.doubles(COUNT, 0, 360).mapToObj(h -> color(h, 40)).toList();
        List<CieLab> second =
                random.doubles(COUNT, 0, 360).mapToObj(h -> color(h, 40)).toList();
        // Four standard deviations, each 1 / sqrt(count).
        assertThat(PhotoComparison.HueComparison.of(first, second).correlation())
                .isCloseTo(0, within(4 / Math.sqrt(COUNT)));
        List<CieLab> grays =
                random.doubles(COUNT, 0, 360).mapToObj(h -> color(h, 5)).toList();
        assertThat(PhotoComparison.HueComparison.of(first, grays).count()).isZero();
        assertThat(PhotoComparison.HueComparison.of(first, grays).line()).contains("too few");
    }
}
