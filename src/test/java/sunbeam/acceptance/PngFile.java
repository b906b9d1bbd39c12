package sunbeam.acceptance;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;

/** Reads text chunks of PNG files and writes files with wrong headers. */
public final class PngFile {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    private PngFile() {}

    /** Returns the tEXt chunks, keyword to value. */
    public static Map<String, String> text(Path file) throws IOException {
        Map<String, String> text = new LinkedHashMap<>();
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).position(SIGNATURE.length);
        while (bytes.hasRemaining()) {
            byte[] data = new byte[bytes.getInt()];
            byte[] type = new byte[4];
            bytes.get(type).get(data).getInt();
            if (new String(type, ISO_8859_1).equals("tEXt")) {
                String[] entry = new String(data, ISO_8859_1).split("\0", 2);
                text.put(entry[0], entry[1]);
            }
        }
        return text;
    }

    /** Writes an 8-bit gray image whose header states more pixels than the file has. */
    public static void writeWithHeaderOf(Path file, int width, int height) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.writeBytes(SIGNATURE);
        byte[] header = ByteBuffer.allocate(13)
                .putInt(width)
                .putInt(height)
                .put(new byte[] {8, 0, 0, 0, 0})
                .array();
        writeChunk(bytes, "IHDR", header);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(packed)) {
            deflater.write(new byte[1000]);
        }
        writeChunk(bytes, "IDAT", packed.toByteArray());
        writeChunk(bytes, "IEND", new byte[0]);
        Files.write(file, bytes.toByteArray());
    }

    private static void writeChunk(ByteArrayOutputStream stream, String type, byte[] data) {
        CRC32 checksum = new CRC32();
        checksum.update(type.getBytes(ISO_8859_1));
        checksum.update(data);
        stream.writeBytes(ByteBuffer.allocate(12 + data.length)
                .putInt(data.length)
                .put(type.getBytes(ISO_8859_1))
                .put(data)
                .putInt((int) checksum.getValue())
                .array());
    }
}
