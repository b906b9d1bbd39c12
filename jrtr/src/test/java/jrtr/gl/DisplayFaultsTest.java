package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class DisplayFaultsTest {
    private static final int FIRST_PORT = 6000;

    private final CountDownLatch lost = new CountDownLatch(1);

    @Test
    void theEndOfTheServerIsReportedButNotThatOfAConnection() throws Exception {
        ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        DisplayFaults.watch("localhost:" + (server.getLocalPort() - FIRST_PORT) + ".0", lost::countDown);
        try (Socket client = server.accept()) {
            client.getOutputStream().write(new byte[32]);
        }
        try (Socket again = server.accept()) {
            assertThat(again.isConnected()).isTrue();
            assertThat(lost.await(200, TimeUnit.MILLISECONDS)).isFalse();
            server.close();
        }
        assertThat(lost.await(30, TimeUnit.SECONDS)).isTrue();
    }

    @Test
    void withoutAServerNothingIsReported() throws IOException, InterruptedException {
        for (String display : new String[] {"", "what is this", ":99999", ":58123"}) {
            DisplayFaults.watch(display, lost::countDown);
        }
        assertThat(lost.await(200, TimeUnit.MILLISECONDS)).isFalse();
    }
}
