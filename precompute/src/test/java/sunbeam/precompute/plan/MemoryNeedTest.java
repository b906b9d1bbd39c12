package sunbeam.precompute.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.shader.ArrayLayout;

class MemoryNeedTest {
    private static final long HEAP = 4L << 30;

    @Test
    void oneTextureMayTakeLessThanAllTogether() {
        // 1.44 GB each: together less than 3 GB, and each less than the 1.5 GiB that Mesa gives to one.
        ArrayLayout half = ArrayLayout.layered("half", 15_000, 1_500, 4, 4);
        assertThat(new MemoryNeed(0, List.of(half, half)).excess(HEAP)).isEmpty();
        ArrayLayout whole = ArrayLayout.layered("whole", 15_000, 1_500, 8, 4);
        assertThat(new MemoryNeed(0, List.of(whole)).excess(HEAP))
                .hasValueSatisfying(line -> assertThat(line).contains("a texture of 2.9 GB", "1.6 GB"));
    }
}
