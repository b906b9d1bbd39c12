package sunbeam.precompute.files;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.zip.CRC32;
import java.util.zip.CRC32C;

/** 64-bit checksum of arrays, CRC-32 beside CRC-32C, fast even in interpreted code. Detects accidents, not manipulation. */
public final class Checksum {
    private final CRC32 first = new CRC32();
    private final CRC32C second = new CRC32C();

    public Checksum add(byte[] bytes) {
        first.update(bytes, 0, bytes.length);
        second.update(bytes, 0, bytes.length);
        return this;
    }

    public Checksum add(float[] values) {
        ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length);
        bytes.asFloatBuffer().put(values);
        return add(bytes.array());
    }

    public Checksum add(int[] values) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * values.length);
        bytes.asIntBuffer().put(values);
        return add(bytes.array());
    }

    /** Returns the checksum as 16 lower-case hexadecimal digits. */
    public String hex() {
        return HexFormat.of().toHexDigits(first.getValue() << Integer.SIZE | second.getValue());
    }
}
