package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.precompute.fault.ScanFaults;
import sunbeam.precompute.optics.HeightMap;

/** Scans of gratings that chance drew have nothing that a scan's faults look like, in floats and in few levels. */
class SoundGratingsTest {
    @ParameterizedTest
    @EnumSource(SimulatedGrating.Kind.class)
    void noFaultIsSeen(SimulatedGrating.Kind kind) {
        // 5015 of rows is a saw that slips sideways, of which most columns jump alike.
        for (long seed : new long[] {5000, 5001, 5015}) {
            SimulatedGrating grating = SimulatedGrating.draw(kind, seed);
            for (int levels : new int[] {0, 16, 256}) {
                assertThat(ScanFaults.in(rounded(grating.map(), levels), Optional.empty()))
                        .as(grating.words() + ", levels " + levels)
                        .isEmpty();
            }
        }
    }

    /** @param levels 0 for heights as they are */
    private static HeightMap rounded(HeightMap map, int levels) {
        double[] heights = map.heights().clone();
        double step = map.relief() / (levels - 1);
        for (int i = 0; i < heights.length && levels > 0; i++) {
            heights[i] = map.minimum() + step * Math.rint((heights[i] - map.minimum()) / step);
        }
        return map.with(heights);
    }
}
