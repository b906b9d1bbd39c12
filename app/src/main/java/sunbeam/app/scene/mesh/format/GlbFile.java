package sunbeam.app.scene.mesh.format;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import sunbeam.app.files.input.InputException;

/**
 * The parts of a glTF file: the chunks of a binary one (.glb), or the text of a .gltf.
 *
 * @param json the text, UTF-8
 * @param binary the binary part, little-endian; empty in a text
 */
record GlbFile(byte[] json, ByteBuffer binary) {
    static final String MAGIC = "glTF";

    // A longer text holds its buffers, and its tree would fill the heap.
    private static final int MOST_TEXT = 24 << 20;
    private static final int HEADER = 12;
    private static final int CHUNK_HEADER = 8;
    private static final int JSON = 0x4E4F534A;
    private static final int BINARY = 0x004E4942;

    /** Maps a file, so that its binary part takes no heap. */
    static GlbFile read(Path file) throws IOException {
        ByteBuffer all = map(file);
        if (all.limit() < HEADER || all.getInt(0) != 0x46546C67) {
            return new GlbFile(text(file, all, 0, all.limit()), ByteBuffer.allocate(0));
        }
        if (all.getInt(4) != 2) {
            throw new InputException(file + ": it is glTF of version " + Integer.toUnsignedLong(all.getInt(4))
                    + "; export it as glTF 2.0");
        }
        int json = chunk(file, all, HEADER, JSON, "JSON");
        int next = HEADER + CHUNK_HEADER + json;
        int binary = next + CHUNK_HEADER > all.limit() ? 0 : chunk(file, all, next, BINARY, "binary");
        return new GlbFile(
                text(file, all, HEADER + CHUNK_HEADER, json),
                binary == 0 ? ByteBuffer.allocate(0) : slice(all, next + CHUNK_HEADER, binary));
    }

    /** A file's bytes, little-endian. */
    static ByteBuffer map(Path file) throws IOException {
        MeshLimits.requireSize(file);
        try (FileChannel channel = FileChannel.open(file)) {
            return channel.map(FileChannel.MapMode.READ_ONLY, 0, channel.size()).order(ByteOrder.LITTLE_ENDIAN);
        }
    }

    static ByteBuffer slice(ByteBuffer buffer, int offset, int length) {
        return buffer.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Returns the length of a chunk, checked to lie in the file. */
    private static int chunk(Path file, ByteBuffer all, int at, int kind, String name) {
        if (at + CHUNK_HEADER > all.limit() || all.getInt(at + 4) != kind) {
            throw new InputException(file + ": there is no " + name + " chunk at byte " + at + "; export it again");
        }
        int length = all.getInt(at);
        if (length < 0 || length > all.limit() - at - CHUNK_HEADER) {
            throw new InputException(file + ": the " + name + " chunk has " + Integer.toUnsignedLong(length)
                    + " bytes, more than the file; copy or export it again");
        }
        return length;
    }

    private static byte[] text(Path file, ByteBuffer all, int offset, int length) {
        if (length > MOST_TEXT) {
            throw new InputException(file + ": its JSON has " + length + " bytes; at most " + MOST_TEXT
                    + " can be used, so export it as .glb");
        }
        byte[] text = new byte[length];
        all.get(offset, text);
        return text;
    }
}
