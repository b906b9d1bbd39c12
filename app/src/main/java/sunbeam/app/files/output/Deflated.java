package sunbeam.app.files.output;

import java.io.ByteArrayOutputStream;
import java.util.zip.Deflater;

/** Compression to zlib's format. */
public final class Deflated {
    private static final int BUFFER_BYTES = 1 << 16;

    private Deflated() {}

    /**
     * Returns the compressed bytes.
     *
     * @param effort compression level of {@link Deflater}, 0 to 9 or -1 for its default
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
