package sunbeam.app.files.output;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import sunbeam.app.terminal.Messages;

/**
 * Sends pictures to the viewer tev on this machine, in little-endian packets of length, operation and data (tev's README, "Over the
 * Network"). If tev ends or receives nothing for {@value #PATIENCE_MILLISECONDS} ms, one warning is printed, and drawing goes on.
 */
public final class TevClient implements AutoCloseable {
    public static final int PORT = 14158;

    private static final int CREATE = 4;
    private static final int UPDATE = 6;
    private static final String[] CHANNELS = {"R", "G", "B", "A"};
    private static final int LARGEST_OVERHEAD_BYTES = 256;

    /** For a connection and each packet: a viewer on this machine receives a picture in less than a second. */
    static final int PATIENCE_MILLISECONDS = 5000;

    private final Socket socket = new Socket();
    private final PrintWriter err;
    private boolean lost;

    private TevClient(PrintWriter err) {
        this.err = err;
    }

    /** Throws OutputException if no program listens on the port, or does not answer. */
    public static TevClient connect(int port, PrintWriter err) {
        TevClient client = new TevClient(err);
        try {
            client.socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), PATIENCE_MILLISECONDS);
            return client;
        } catch (IOException refused) {
            client.close();
            String reason = refused instanceof SocketTimeoutException
                    ? "what listens there does not answer"
                    : "nothing listens there";
            throw new OutputException(
                    "--tev: no tev on port " + port + " of this machine (" + reason
                            + "); start tev first, or leave --tev out",
                    refused);
        }
    }

    /** Creates a black picture, also in place of one. */
    public void create(String name, int width, int height) {
        ByteBuffer packet = packet(CREATE, 1, name, 0);
        packet.putInt(width).putInt(height);
        putChannels(packet);
        send(packet);
    }

    /** Fills a rectangle: {@code height x width x 3}, NaN without surface; tev gets linear Rec. 709 and alpha. */
    public void update(String name, int x, int y, int width, int height, float[] xyz) {
        float[] rgba = LinearFile.rgba(xyz);
        ByteBuffer packet = packet(UPDATE, 0, name, rgba.length);
        putChannels(packet);
        packet.putInt(x).putInt(y).putInt(width).putInt(height);
        for (int channel = 0; channel < CHANNELS.length; channel++) {
            packet.putLong(channel); // index of the channel's first value
        }
        for (int channel = 0; channel < CHANNELS.length; channel++) {
            packet.putLong(CHANNELS.length); // values from pixel to pixel
        }
        packet.asFloatBuffer().put(rgba); // does not move the packet's position
        packet.position(packet.position() + Float.BYTES * rgba.length);
        send(packet);
    }

    private static ByteBuffer packet(int operation, int flag, String name, int values) {
        byte[] nameBytes = string(name);
        int room = Math.addExact(nameBytes.length + LARGEST_OVERHEAD_BYTES, Math.multiplyExact(Float.BYTES, values));
        ByteBuffer packet = ByteBuffer.allocate(room).order(ByteOrder.LITTLE_ENDIAN);
        return packet.putInt(0).put((byte) operation).put((byte) flag).put(nameBytes);
    }

    private static void putChannels(ByteBuffer packet) {
        packet.putInt(CHANNELS.length);
        for (String channel : CHANNELS) {
            packet.put(string(channel));
        }
    }

    private static byte[] string(String text) {
        return (text + "\0").getBytes(StandardCharsets.UTF_8);
    }

    private void send(ByteBuffer packet) {
        if (lost) {
            return;
        }
        byte[] bytes = new byte[packet.position()];
        packet.putInt(0, bytes.length).flip().get(bytes);
        FutureTask<Void> sent = new FutureTask<>(() -> {
            socket.getOutputStream().write(bytes);
            return null;
        });
        Thread thread = new Thread(sent, "tev");
        thread.setDaemon(true);
        thread.start();
        try {
            sent.get(PATIENCE_MILLISECONDS, TimeUnit.MILLISECONDS);
        } catch (TimeoutException stalled) {
            end("no answer for " + PATIENCE_MILLISECONDS / 1000 + " s");
        } catch (ExecutionException gone) {
            end(gone.getCause().getMessage());
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        }
    }

    /** Ends also a write that still waits. */
    private void end(String reason) {
        close();
        err.println(Messages.warning("tev takes no more pictures (" + reason + "); drawing goes on"));
    }

    @Override
    public void close() {
        lost = true;
        try {
            socket.close();
        } catch (IOException gone) {
            // Nothing is left to send.
        }
    }
}
