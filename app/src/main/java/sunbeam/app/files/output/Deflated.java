package sunbeam.app.files.output;

import java.io.ByteArrayOutputStream;
import java.util.zip.Deflater;

/** Bytes in zlib's format. */
public final class Deflated {
    private static final int BUFFER_BYTES = 1 << 16;

    private Deflated() {}

    /**
     * Compresses.
     *
     * @param effort level of {@link Deflater}
     */
    public static byte[] of(byte[] bytes, int effort) {
        Deflater deflater = new Deflater(effort);
        try {
            deflater.setInput(bytes);
            deflater.finish();
            ByteArrayOutputStream packed = new ByteArrayOutputStream();
            byte[] buffer = new byte[BUFFER_BYTES];
            while (!deflater.finished()) {
                packed.write(buffer, 0, deflater.deflate(buffer));
            }
            return packed.toByteArray();
        } finally {
            deflater.end();
        }
    }
}
