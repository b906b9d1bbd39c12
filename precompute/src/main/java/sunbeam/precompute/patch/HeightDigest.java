package sunbeam.precompute.patch;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import sunbeam.precompute.text.Sha256;

/** Fingerprint of a height map for cache keys: equal for equal surfaces, whatever file they came from. */
public final class HeightDigest {
    private static final int HEIGHTS_PER_BLOCK = 8192;

    private HeightDigest() {}

    /**
     * SHA-256, 64 lower-case hexadecimal digits, of columns and rows (int), pitch along x and y and all heights row by
     * row (IEEE doubles), big-endian, after a tag that names this layout.
     */
    public static String sha256(HeightMap map) {
        MessageDigest digest = Sha256.digest();
        digest.update("sunbeam height map 1\n".getBytes(StandardCharsets.US_ASCII));
        ByteBuffer block = ByteBuffer.allocate(HEIGHTS_PER_BLOCK * Double.BYTES);
        block.putInt(map.columns()).putInt(map.rows());
        block.putDouble(map.pitchX()).putDouble(map.pitchY());
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                if (block.remaining() < Double.BYTES) {
                    digest.update(block.flip());
                    block.clear();
                }
                block.putDouble(map.at(column, row));
            }
        }
        digest.update(block.flip());
        return Sha256.hexadecimal(digest);
    }
}
