package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.HeightMap;

/** Levels and the digest of height maps. */
class HeightLevelsTest {
    private static final int SIDE = 40;

    /** Asserts that the levels are the sorted distinct heights and that each sample's index finds its height; returns the levels. */
    private static HeightLevels assertSortedDistinctAndIndexed(IntToDoubleFunction heights) {
        double[] samples = new double[SIDE * SIDE];
        Arrays.setAll(samples, heights);
        HeightLevels levels = new HeightLevels(new HeightMap(SIDE, SIDE, 1e-8, 1e-8, samples));

        assertThat(levels.levels())
                .containsExactly(Arrays.stream(samples)
                        .map(h -> h + 0.0)
                        .sorted()
                        .distinct()
                        .toArray());
        for (int i = 0; i < samples.length; i++) {
            assertThat(levels.levels()[levels.index()[i]]).isEqualTo(samples[i] + 0.0);
        }
        return levels;
    }

    @Test
    void everySampleHasItsLevelAndMinusZeroIsZero() {
        Random random = new Random(4);
        assertSortedDistinctAndIndexed(i -> 1e-7 * random.nextGaussian());
        HeightLevels bytes = assertSortedDistinctAndIndexed(i -> 1e-9 * random.nextInt(256));
        assertThat(bytes.count()).isBetween(250, 256);
        HeightLevels flat = assertSortedDistinctAndIndexed(i -> 3e-9);
        assertThat(flat.count()).isEqualTo(1);
        HeightLevels zeros =
                assertSortedDistinctAndIndexed(i -> i % 3 == 0 ? -0.0 : i % 3 == 1 ? 0.0 : Double.MIN_VALUE);
        assertThat(zeros.count()).isEqualTo(2);
    }

    @Test
    void aGrainOfDustDoesNotMixUpTheRest() {
        Random random = new Random(5);
        // All levels but one lie in one step of the search.
        assertSortedDistinctAndIndexed(i -> i == 77 ? 1e-3 : 1e-12 * random.nextInt(500));
        assertSortedDistinctAndIndexed(i -> i == 77 ? -Double.MAX_VALUE : i == 78 ? Double.MAX_VALUE : i);
    }

    /** The decision is based on 8192 samples; 4096 levels of a scan are not many, rare levels are. */
    @Test
    void estimatesWhetherLevelsAreMany() {
        Random random = new Random(6);
        int side = 300;
        double[] samples = new double[side * side];
        for (int levels : new int[] {1, 2, 256, 4096, 10_000}) {
            Arrays.setAll(samples, i -> 1e-9 * random.nextInt(levels));
            HeightLevels few = new HeightLevels(new HeightMap(side, side, 1e-8, 1e-8, samples.clone()));
            assertThat(few.areTooManyToTabulate()).as("%d levels", levels).isFalse();
        }
        Arrays.setAll(samples, i -> random.nextGaussian());
        assertThat(new HeightLevels(new HeightMap(side, side, 1e-8, 1e-8, samples)).areTooManyToTabulate())
                .isTrue();
    }

    private final double[] heights = new Random(6).doubles(200 * 90).toArray();

    @Test
    void theDigestIsTheSha256OfTheDocumentedLayout() throws Exception {
        ByteBuffer layout = ByteBuffer.allocate(21 + 24 + 8 * heights.length);
        layout.put("sunbeam height map 1\n".getBytes(StandardCharsets.US_ASCII));
        layout.putInt(200).putInt(90).putDouble(1e-9).putDouble(2e-9);
        for (double height : heights) {
            layout.putDouble(height);
        }
        String expected =
                HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(layout.array()));

        assertThat(new HeightMap(200, 90, 1e-9, 2e-9, heights).digest()).isEqualTo(expected);
    }
}
