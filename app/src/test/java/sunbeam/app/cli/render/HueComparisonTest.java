package sunbeam.app.cli.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.CieLab;

class HueComparisonTest {
    private static final int COUNT = 2000;

    private static List<CieLab> colors(DoubleStream hues, double chroma) {
        return hues.map(Math::toRadians)
                .mapToObj(hue -> new CieLab(50, chroma * Math.cos(hue), chroma * Math.sin(hue)))
                .toList();
    }

    /** The second hues are the first, turned by 25 degrees with errors of 3 degrees. */
    @Test
    void hueThatIsTurnedIsCorrelatedAndToldByHowMuch() {
        Random random = new Random(1);
        double[] hues = random.doubles(COUNT, 0, 180).toArray();
        List<CieLab> first = colors(Arrays.stream(hues), 40);
        List<CieLab> second = colors(Arrays.stream(hues).map(hue -> hue + 25 + 3 * random.nextGaussian()), 20);
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
        List<CieLab> first = colors(random.doubles(COUNT, 0, 360), 40);
        List<CieLab> second = colors(random.doubles(COUNT, 0, 360), 40);
        // Four standard deviations, each 1 / sqrt(count).
        assertThat(PhotoComparison.HueComparison.of(first, second).correlation())
                .isCloseTo(0, within(4 / Math.sqrt(COUNT)));
        List<CieLab> grays = colors(random.doubles(COUNT, 0, 360), 5);
        assertThat(PhotoComparison.HueComparison.of(first, grays).count()).isZero();
        assertThat(PhotoComparison.HueComparison.of(first, grays).line()).contains("too few");
    }
}
