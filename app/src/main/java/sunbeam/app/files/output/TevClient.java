package sunbeam.app.files.output;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import sunbeam.app.terminal.Messages;

/**
 * Sends pictures to the viewer tev, which listens on this machine. Packets are little endian: length of the whole packet, operation, and
 * the operation's data (tev's README, "Over the Network"). If tev ends, or receives nothing for {@value #PATIENCE_MILLISECONDS} ms, one
 * warning is printed, and drawing goes on.
 */
public final class TevClient implements AutoCloseable {
    public static final int PORT = 14158;

    private static final int CREATE = 4;
    private static final int UPDATE = 6;
    private static final String[] CHANNELS = {"R", "G", "B", "A"};
    private static final int LARGEST_OVERHEAD_BYTES = 256;

    /** Longest wait for a connection, and for each packet: a viewer on the same machine receives a picture in less than a second. */
    static final long PATIENCE_MILLISECONDS = 5000;

    /** Non-blocking; {@link #await} waits. */
    private final SocketChannel socket;

    private final Selector selector;
    private final PrintWriter err;
    private boolean lost;

    private TevClient(SocketChannel socket, Selector selector, PrintWriter err) {
        this.socket = socket;
        this.selector = selector;
        this.err = err;
    }

    /**
     * Connects to tev on this machine.
     *
     * @throws OutputException if no program listens on the port, or does not answer
     */
    public static TevClient connect(int port, PrintWriter err) {
        TevClient client = null;
        try {
            client = new TevClient(SocketChannel.open(), Selector.open(), err);
            client.open(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
            return client;
        } catch (IOException refused) {
            if (client != null) {
                client.close();
            }
            String reason = refused instanceof SocketTimeoutException
                    ? "what listens there does not answer"
                    : "nothing listens there";
            throw new OutputException(
                    "--tev: no tev on port " + port + " of this machine (" + reason
                            + "); start tev first, or leave --tev out",
                    refused);
        }
    }

    private void open(InetSocketAddress address) throws IOException {
        socket.configureBlocking(false);
        socket.register(selector, SelectionKey.OP_CONNECT);
        long start = System.nanoTime();
        boolean connected = socket.connect(address);
        while (!connected) {
            await(SelectionKey.OP_CONNECT, start);
            connected = socket.finishConnect();
        }
    }

    /**
     * Waits until the socket is ready for an operation; throws an exception if that takes longer than {@link #PATIENCE_MILLISECONDS} from
     * the start.
     */
    private void await(int operation, long start) throws IOException {
        long left = PATIENCE_MILLISECONDS - TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - start);
        socket.keyFor(selector).interestOps(operation);
        if (left <= 0 || selector.select(left) == 0) {
            throw new SocketTimeoutException("no answer for " + PATIENCE_MILLISECONDS / 1000 + " s");
        }
        selector.selectedKeys().clear();
    }

    /** Creates a black picture, which replaces one of the same name. */
    public void create(String name, int width, int height) {
        ByteBuffer packet = packet(CREATE, 1, name, 0);
        packet.putInt(width).putInt(height);
        putChannels(packet);
        send(packet);
    }

    /**
     * Fills a rectangle of a picture.
     *
     * @param x left column of the rectangle
     * @param y top row of the rectangle
     * @param xyz {@code height x width x 3}, CIE XYZ, NaN where there is no surface; tev gets linear Rec. 709 and alpha
     */
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
        return ByteBuffer.allocate(room)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(0)
                .put((byte) operation)
                .put((byte) flag)
                .put(nameBytes);
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
        packet.putInt(0, packet.position()).flip();
        long start = System.nanoTime();
        try {
            while (packet.hasRemaining()) {
                if (socket.write(packet) == 0) {
                    await(SelectionKey.OP_WRITE, start);
                }
            }
        } catch (IOException gone) {
            lost = true;
            err.println(Messages.warning("tev takes no more pictures (" + gone.getMessage() + "); drawing goes on"));
        }
    }

    @Override
    public void close() {
        try {
            selector.close();
            socket.close();
        } catch (IOException gone) {
            lost = true;
        }
    }
}
