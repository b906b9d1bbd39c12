package sunbeam.precompute.optics;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;

class HeightMapTest {
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
