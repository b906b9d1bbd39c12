package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Against a server that speaks just the first words of the protocol. */
class DisplayWatchTest {
    private static final int FIRST_PORT = 6000;

    @TempDir
    private Path folder;

    private final CountDownLatch lost = new CountDownLatch(1);
    private ServerSocket server;

    @BeforeEach
    void listen() throws IOException {
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        server.setSoTimeout(30_000);
    }

    @AfterEach
    void close() throws IOException {
        server.close();
    }

    private int display() {
        return server.getLocalPort() - FIRST_PORT;
    }

    private Thread watch() {
        return DisplayWatch.watch(
                Map.of(
                        "DISPLAY",
                        "localhost:" + display() + ".0",
                        "XAUTHORITY",
                        folder.resolve("keys").toString()),
                lost::countDown);
    }

    /** The request without its padding; what answers is success (1) or failure (0), with 4 bytes of further words. */
    private static String setUp(Socket client, int answer) throws IOException {
        DataInputStream in = new DataInputStream(client.getInputStream());
        byte[] head = in.readNBytes(12);
        assertThat(head[0]).isEqualTo((byte) 'l');
        assertThat(head[2]).as("the protocol's version").isEqualTo((byte) 11);
        byte[] name = in.readNBytes((head[6] + 3) / 4 * 4);
        byte[] key = in.readNBytes((head[8] + 3) / 4 * 4);
        client.getOutputStream().write(new byte[] {(byte) answer, 0, 11, 0, 0, 0, 1, 0, 'w', 'o', 'r', 'd'});
        return new String(name, 0, head[6], StandardCharsets.US_ASCII)
                + " "
                + new String(key, 0, head[8], StandardCharsets.US_ASCII);
    }

    private void writeKeys(String... displaysAndKeys) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        for (int i = 0; i < displaysAndKeys.length; i += 2) {
            out.writeShort(256);
            for (String field :
                    new String[] {"host", displaysAndKeys[i], "MIT-MAGIC-COOKIE-1", displaysAndKeys[i + 1]}) {
                out.writeShort(field.length());
                out.writeBytes(field);
            }
        }
        Files.write(folder.resolve("keys"), bytes.toByteArray());
    }

    @Test
    void anEndOfTheServerIsToldAndItsEventsAreNot() throws Exception {
        Thread watching = watch();
        try (Socket client = server.accept()) {
            setUp(client, 1);
            client.getOutputStream().write(new byte[3200]);
            assertThat(lost.await(200, TimeUnit.MILLISECONDS)).isFalse();
        }
        assertThat(lost.await(30, TimeUnit.SECONDS)).isTrue();
        watching.join();
    }

    @Test
    void theKeyIsTheDisplaysOwn() throws Exception {
        writeKeys("70000", "another's", "" + display(), "its own");
        Thread watching = watch();
        try (Socket client = server.accept()) {
            assertThat(setUp(client, 1)).isEqualTo("MIT-MAGIC-COOKIE-1 its own");
        }
        watching.join();
    }

    @Test
    void aServerThatLetsNobodyElseInIsNotWatched() throws Exception {
        Thread watching = watch();
        try (Socket client = server.accept()) {
            assertThat(setUp(client, 0)).isEqualTo(" ");
        }
        watching.join();
        assertThat(lost.getCount()).isEqualTo(1);
    }

    @Test
    void whereThereIsNoServerNothingIsLost() throws Exception {
        server.close();
        watch().join();
        DisplayWatch.watch(Map.of(), lost::countDown).join();
        DisplayWatch.watch(Map.of("DISPLAY", "what is this"), lost::countDown).join();
        DisplayWatch.watch(Map.of("DISPLAY", ":99999"), lost::countDown).join();
        assertThat(lost.getCount()).isEqualTo(1);
    }
}
