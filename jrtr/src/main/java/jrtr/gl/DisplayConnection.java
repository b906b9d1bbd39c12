package jrtr.gl;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A connection to an X server, set up as section 8 of the X Window System Protocol (X11R7) says, and nothing more. */
final class DisplayConnection {
    private static final Pattern DISPLAY = Pattern.compile("(?:unix/?)?([^:/]*):(\\d{1,5})(?:\\.\\d+)?");
    private static final String COOKIE = "MIT-MAGIC-COOKIE-1";
    private static final int FIRST_PORT = 6000;
    private static final int LAST_DISPLAY = 0xffff - FIRST_PORT;
    private static final int REPLY_HEAD_BYTES = 8;
    private static final byte LITTLE_ENDIAN = 'l';
    private static final byte SUCCESS = 1;

    private DisplayConnection() {}

    /**
     * Connects to the server of {@code DISPLAY}, with the key of {@code XAUTHORITY} or {@code ~/.Xauthority}.
     *
     * @throws EOFException when it lets go of us before we are in, as one does that starts anew
     * @throws IOException when there is none, or it does not let us in
     */
    static SocketChannel open(Map<String, String> environment) throws IOException {
        Matcher display = DISPLAY.matcher(environment.getOrDefault("DISPLAY", ""));
        if (!display.matches() || Integer.parseInt(display.group(2)) > LAST_DISPLAY) {
            throw new IOException("DISPLAY names no display");
        }
        SocketChannel server = display.group(1).isEmpty()
                ? SocketChannel.open(UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + display.group(2)))
                : SocketChannel.open(
                        new InetSocketAddress(display.group(1), FIRST_PORT + Integer.parseInt(display.group(2))));
        try {
            setUp(server, key(environment, display.group(2)));
            return server;
        } catch (SocketException reset) {
            server.close();
            throw (EOFException) new EOFException("the X server has let go").initCause(reset);
        } catch (IOException refused) {
            server.close();
            throw refused;
        }
    }

    private static void setUp(SocketChannel server, byte[] key) throws IOException {
        byte[] protocol = key.length == 0 ? new byte[0] : COOKIE.getBytes(StandardCharsets.US_ASCII);
        ByteBuffer request = ByteBuffer.allocate(12 + padded(protocol.length) + padded(key.length))
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(LITTLE_ENDIAN)
                .put((byte) 0)
                .putShort((short) 11)
                .putShort((short) 0)
                .putShort((short) protocol.length)
                .putShort((short) key.length)
                .putShort((short) 0);
        request.put(protocol).position(12 + padded(protocol.length));
        request.put(key);
        request.clear();
        while (request.hasRemaining()) {
            server.write(request);
        }
        ByteBuffer head = read(server, REPLY_HEAD_BYTES);
        if (head.get(0) != SUCCESS) {
            throw new IOException("the X server lets nobody else in");
        }
        read(server, 4 * Short.toUnsignedInt(head.getShort(6)));
    }

    private static int padded(int bytes) {
        return (bytes + 3) / 4 * 4;
    }

    private static ByteBuffer read(SocketChannel server, int bytes) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
        while (buffer.hasRemaining()) {
            if (server.read(buffer) < 0) {
                throw new EOFException();
            }
        }
        return buffer.flip();
    }

    /** The first cookie of a file in the form of Xau(3) that is for the display or for any; empty where there is none. */
    private static byte[] key(Map<String, String> environment, String number) throws IOException {
        String named = environment.getOrDefault("XAUTHORITY", "");
        Path file = named.isEmpty() ? Path.of(environment.getOrDefault("HOME", ""), ".Xauthority") : Path.of(named);
        if (!Files.isRegularFile(file)) {
            return new byte[0];
        }
        try (DataInputStream entries = new DataInputStream(Files.newInputStream(file))) {
            while (true) {
                entries.readUnsignedShort(); // the family of the address
                field(entries);
                String display = new String(field(entries), StandardCharsets.US_ASCII);
                String protocol = new String(field(entries), StandardCharsets.US_ASCII);
                byte[] key = field(entries);
                if (protocol.equals(COOKIE) && (display.isEmpty() || display.equals(number))) {
                    return key;
                }
            }
        } catch (EOFException none) {
            return new byte[0];
        }
    }

    private static byte[] field(DataInputStream entries) throws IOException {
        byte[] content = new byte[entries.readUnsignedShort()];
        entries.readFully(content);
        return content;
    }
}
