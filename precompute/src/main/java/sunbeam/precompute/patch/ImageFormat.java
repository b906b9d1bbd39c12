package sunbeam.precompute.patch;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** The image formats that carry heights, told apart by their first bytes, never by the file's name. */
enum ImageFormat {
    PNG,
    TIFF,
    BMP;

    private static final int HEAD_BYTES = 34;
    private static final int BMP_COMPRESSION_OFFSET = 30;
    private static final int BMP_EMBEDDED_JPEG = 4;
    private static final int BMP_EMBEDDED_PNG = 5;

    /**
     * The format of an existing file.
     *
     * @throws PatchException when it is none of these, or a BMP that is only a wrapper around another image
     */
    static ImageFormat of(Path file) throws IOException {
        byte[] head;
        try (InputStream in = Files.newInputStream(file)) {
            head = in.readNBytes(HEAD_BYTES);
        }
        if (startsWith(head, 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n')) {
            return PNG;
        }
        if (startsWith(head, 'I', 'I', 42, 0) || startsWith(head, 'M', 'M', 0, 42)) {
            return TIFF;
        }
        if (startsWith(head, 'B', 'M')) {
            requirePlainBmp(file, head);
            return BMP;
        }
        if (startsWith(head, 0xff, 0xd8, 0xff)) {
            throw new PatchException(
                    file + " is a JPEG, whose compression falsifies heights; export the scan as PNG, TIFF or BMP");
        }
        throw new PatchException(file
                + (head.length == 0 ? " is empty" : " is not a PNG, TIFF or BMP image")
                + "; export the scan as 8- or 16-bit PNG or as TIFF");
    }

    /** Whether a file is a picture of any kind, read or refused here; another may be a scan that others can read. */
    static boolean isPicture(byte[] head) {
        return head.length == 0
                || startsWith(head, 0x89, 'P', 'N', 'G')
                || startsWith(head, 'I', 'I', 42, 0)
                || startsWith(head, 'M', 'M', 0, 42)
                || startsWith(head, 'B', 'M')
                || startsWith(head, 0xff, 0xd8, 0xff)
                || startsWith(head, 'G', 'I', 'F', '8')
                || startsWith(head, 'R', 'I', 'F', 'F')
                || startsWith(head, '%', 'P', 'D', 'F');
    }

    private static void requirePlainBmp(Path file, byte[] head) {
        int compression = head.length > BMP_COMPRESSION_OFFSET ? head[BMP_COMPRESSION_OFFSET] : 0;
        if (compression == BMP_EMBEDDED_JPEG || compression == BMP_EMBEDDED_PNG) {
            throw new PatchException(file + " is a BMP around another image; save it as PNG or as uncompressed BMP");
        }
    }

    private static boolean startsWith(byte[] head, int... expected) {
        if (head.length < expected.length) {
            return false;
        }
        for (int i = 0; i < expected.length; i++) {
            if ((head[i] & 0xff) != expected[i]) {
                return false;
            }
        }
        return true;
    }
}
