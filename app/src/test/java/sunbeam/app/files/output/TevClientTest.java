package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.time.Duration;
import java.util.HexFormat;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class TevClientTest {
    /** Packets that tev's own Python client (tevclient 1.0.4) sends for the same pictures, without the pixels. */
    private static final String CREATE =
            "1e000000" + "04" + "01" + "6d617000" + "03000000" + "02000000" + "04000000" + "5200470042004100";

    private static final String UPDATE = "86000000" + "06" + "00" + "6d617000" + "04000000" + "5200470042004100"
            + "01000000" + "00000000" + "02000000" + "01000000"
            + "0000000000000000" + "0100000000000000" + "0200000000000000" + "0300000000000000"
            + "0400000000000000".repeat(4);

    private final StringWriter said = new StringWriter();

    @Test
    void packetsAreThoseOfTevsOwnClient() throws IOException {
        try (ServerSocket server = listening()) {
            TevClient client = TevClient.connect(server.getLocalPort(), new PrintWriter(said, true));
            try (Socket tev = server.accept()) {
                client.create("map", 3, 2);
                // White of D65, and no surface.
                client.update("map", 1, 0, 2, 1, new float[] {0.95047f, 1, 1.08883f, Float.NaN, Float.NaN, Float.NaN});
                client.close();
                byte[] sent = tev.getInputStream().readAllBytes();

                String hex = HexFormat.of().formatHex(sent);
                assertThat(hex).startsWith(CREATE + UPDATE);
                FloatBuffer pixels = ByteBuffer.wrap(sent)
                        .order(ByteOrder.LITTLE_ENDIAN)
                        .position((CREATE + UPDATE).length() / 2)
                        .asFloatBuffer();
                assertThat(pixels.remaining()).isEqualTo(8);
                for (int channel = 0; channel < 4; channel++) {
                    // The white has five digits.
                    assertThat(pixels.get(channel)).isCloseTo(1, Offset.offset(1e-4f));
                    assertThat(pixels.get(4 + channel)).isZero();
                }
            }
        }
    }

    @Test
    void aMissingTevIsReportedInOneLine() throws IOException {
        int port;
        try (ServerSocket server = listening()) {
            port = server.getLocalPort();
        }

        assertThatThrownBy(() -> TevClient.connect(port, new PrintWriter(said)))
                .isInstanceOf(OutputException.class)
                .hasMessage("--tev: no tev on port " + port
                        + " of this machine (nothing listens there); start tev first, or leave --tev out");
    }

    @Test
    void aTevThatEndsIsOneWarning() throws IOException {
        try (ServerSocket server = listening();
                TevClient client = TevClient.connect(server.getLocalPort(), new PrintWriter(said, true))) {
            server.accept().close();
            for (int i = 0; i < 50; i++) {
                client.create("map", 1, 1);
            }
            assertThat(said.toString()).hasLineCount(1).contains("tev takes no more pictures");
        }
    }

    /** A server that accepts and never reads: its buffers and ours are full after some megabytes. */
    @Test
    void aTevThatStallsIsOneWarningAfterFiveSeconds() throws IOException {
        try (ServerSocket server = listening();
                TevClient client = TevClient.connect(server.getLocalPort(), new PrintWriter(said, true));
                Socket stalled = server.accept()) {
            long start = System.nanoTime();
            int side = 2048;
            for (int i = 0; i < 4; i++) {
                client.update("map", 0, 0, side, side, new float[3 * side * side]);
            }
            assertThat(stalled.isConnected()).isTrue();
            // Twice the patience, for a busy machine.
            assertThat((int) Duration.ofNanos(System.nanoTime() - start).toMillis())
                    .isBetween(TevClient.PATIENCE_MILLISECONDS, 2 * TevClient.PATIENCE_MILLISECONDS);
            assertThat(said.toString()).hasLineCount(1).contains("tev takes no more pictures (no answer for 5 s)");
        }
    }

    private static ServerSocket listening() throws IOException {
        return new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    }
}
