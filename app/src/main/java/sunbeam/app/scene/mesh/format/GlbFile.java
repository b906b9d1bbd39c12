package sunbeam.app.scene.mesh.format;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import sunbeam.precompute.files.InputException;

/**
 * The parts of a glTF file: the chunks of a binary file (.glb), or the JSON text of a text file (.gltf).
 *
 * @param binary binary chunk, little-endian; empty in a text file
 */
record GlbFile(byte[] json, ByteBuffer binary) {
    static final String MAGIC = "glTF";
    // The same four characters, little-endian.
    private static final int MAGIC_NUMBER = 0x46546C67;

    // A longer text contains its buffers as base64, and its parsed tree would fill the heap.
    private static final int MOST_JSON_BYTES = 24 << 20;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;
    // Chunk types: "JSON" and "BIN\0" in little-endian ASCII.
    private static final int JSON = 0x4E4F534A;
    private static final int BINARY = 0x004E4942;

    /** Reads a file; the binary part is memory-mapped. */
    static GlbFile read(Path file) throws IOException {
        ByteBuffer all = map(file);
        if (all.limit() < HEADER_BYTES || all.getInt(0) != MAGIC_NUMBER) {
            return new GlbFile(text(all, 0, all.limit()), ByteBuffer.allocate(0));
        }
        if (all.getInt(4) != 2) {
            throw new InputException(
                    "it is glTF of version " + Integer.toUnsignedLong(all.getInt(4)) + "; export it as glTF 2.0");
        }
        int json = chunk(all, HEADER_BYTES, JSON, "JSON");
        int next = HEADER_BYTES + CHUNK_HEADER_BYTES + json;
        int binary = next + CHUNK_HEADER_BYTES > all.limit() ? 0 : chunk(all, next, BINARY, "binary");
        return new GlbFile(
                text(all, HEADER_BYTES + CHUNK_HEADER_BYTES, json),
                binary == 0 ? ByteBuffer.allocate(0) : slice(all, next + CHUNK_HEADER_BYTES, binary));
    }

    static ByteBuffer map(Path file) throws IOException {
        MeshFormat.requireSize(file);
        try (FileChannel channel = FileChannel.open(file)) {
            return channel.map(FileChannel.MapMode.READ_ONLY, 0, channel.size()).order(ByteOrder.LITTLE_ENDIAN);
        }
    }

    static ByteBuffer slice(ByteBuffer buffer, int offset, int length) {
        return buffer.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static int chunk(ByteBuffer all, int at, int kind, String name) {
        if (at + CHUNK_HEADER_BYTES > all.limit() || all.getInt(at + 4) != kind) {
            throw new InputException("there is no " + name + " chunk at byte " + at + "; export it again");
        }
        int length = all.getInt(at);
        if (length < 0 || length > all.limit() - at - CHUNK_HEADER_BYTES) {
            throw new InputException("the " + name + " chunk has " + Integer.toUnsignedLong(length)
                    + " bytes, more than the file; copy or export it again");
        }
        return length;
    }

    private static byte[] text(ByteBuffer all, int offset, int length) {
        if (length > MOST_JSON_BYTES) {
            throw new InputException("its JSON has " + length + " bytes; at most " + MOST_JSON_BYTES
                    + " can be used, so export it as .glb");
        }
        byte[] text = new byte[length];
        all.get(offset, text);
        return text;
    }
}
