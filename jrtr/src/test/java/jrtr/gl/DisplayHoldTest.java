package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** Against a server that speaks just the first words of the protocol. */
class DisplayHoldTest {
    private static final int FIRST_PORT = 6000;

    private static Map<String, String> environment(ServerSocket server) {
        return Map.of("DISPLAY", "localhost:" + (server.getLocalPort() - FIRST_PORT), "XAUTHORITY", "/nowhere");
    }

    @Test
    void aServerThatStartsAnewIsAskedAgain() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            server.setSoTimeout(30_000);
            CompletableFuture<Void> answers = CompletableFuture.runAsync(() -> {
                try {
                    server.accept().close();
                    try (Socket second = server.accept()) {
                        new DataInputStream(second.getInputStream()).readNBytes(12);
                        second.getOutputStream().write(new byte[] {1, 0, 11, 0, 0, 0, 0, 0});
                        assertThat(second.getInputStream().read())
                                .as("held until it is closed")
                                .isEqualTo(-1);
                    }
                } catch (IOException failure) {
                    throw new AssertionError(failure);
                }
            });
            try (DisplayHold hold = DisplayHold.take(environment(server))) {
                assertThat(hold.holds()).isTrue();
                assertThat(answers).isNotDone();
            }
            answers.get(30, TimeUnit.SECONDS);
        }
    }

    @Test
    void whatCannotBeReachedIsNotHeld() throws IOException {
        Map<String, String> gone;
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            gone = environment(server);
        }
        try (DisplayHold hold = DisplayHold.take(gone)) {
            assertThat(hold.holds()).isFalse();
        }
        try (DisplayHold hold = DisplayHold.take(Map.of())) {
            assertThat(hold.holds()).isFalse();
        }
    }
}
