package sunbeam.app.scene.mesh.format;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.text.Quoted;

/** The numbers of a PLY file behind its header, one after the other. */
interface PlyNumbers {

    /**
     * The next number.
     *
     * @throws EOFException at the file's end
     * @throws IllegalArgumentException if it is no number, with a message that says so
     */
    double next(SampleType type) throws IOException;

    /** Those of a stream that stands behind the header. */
    static PlyNumbers of(PlyHeader.Encoding encoding, InputStream stream) {
        return switch (encoding) {
            case ASCII -> type -> word(stream);
            case BINARY_LITTLE_ENDIAN -> binary(stream, ByteOrder.LITTLE_ENDIAN);
            case BINARY_BIG_ENDIAN -> binary(stream, ByteOrder.BIG_ENDIAN);
        };
    }

    private static PlyNumbers binary(InputStream stream, ByteOrder order) {
        DataInputStream data = new DataInputStream(stream);
        ByteBuffer bytes = ByteBuffer.allocate(Double.BYTES).order(order);
        return type -> {
            data.readFully(bytes.array(), 0, type.size());
            return type.decode(bytes, 0);
        };
    }

    private static double word(InputStream stream) throws IOException {
        StringBuilder word = new StringBuilder();
        int next = stream.read();
        while (next >= 0 && next <= ' ') {
            next = stream.read();
        }
        while (next > ' ' && word.length() <= 60) {
            word.append((char) next);
            next = stream.read();
        }
        if (word.isEmpty()) {
            throw new EOFException();
        }
        try {
            return Double.parseDouble(word.toString());
        } catch (NumberFormatException wrong) {
            throw new IllegalArgumentException(
                    Quoted.of(word.toString()) + " is no number; export the mesh again", wrong);
        }
    }
}
