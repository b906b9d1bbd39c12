package sunbeam.app.files.cache;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import sunbeam.precompute.shader.ShaderTablesFile;
import sunbeam.precompute.shader.TableException;
import sunbeam.precompute.shader.TableLabel;

/**
 * File in the cache folder.
 *
 * @param bytes length of the file
 * @param lastUsed time of the last read, or of the write if there was no read
 */
public record CacheEntry(Path file, long bytes, Instant lastUsed) {
    static final String SHADER = "tables";
    static final String TILES = "tiles";
    static final String BYTES = "bytes";

    // Hexadecimal digits in a file's name, of the surface's digest and of the hash of the key.
    private static final int SURFACE_DIGITS = 12;
    private static final int KEY_DIGITS = 32;

    static String name(String surfaceDigest, String keyHash, String ending) {
        return surfaceDigest.substring(0, SURFACE_DIGITS) + "-" + keyHash.substring(0, KEY_DIGITS) + "." + ending;
    }

    static String name(String keyHash) {
        return keyHash.substring(0, KEY_DIGITS) + "." + BYTES;
    }

    boolean isTilesOf(String surfaceDigest) {
        String name = file.getFileName().toString();
        return name.startsWith(surfaceDigest.substring(0, SURFACE_DIGITS)) && name.endsWith("." + TILES);
    }

    static boolean isOne(Path file) {
        return List.of(SHADER, TILES, BYTES).contains(ending(file));
    }

    private static String ending(Path file) {
        String name = file.getFileName().toString();
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /**
     * Reads the label of the table and its surface, without checking the rest of the file.
     *
     * @throws TableException if the file is damaged, of another version, or gone
     */
    public TableLabel label() {
        return switch (ending(file)) {
            case TILES -> TileFile.label(file, TileFile.FORMAT);
            case BYTES -> TileFile.label(file, BlobCache.FORMAT);
            default -> ShaderTablesFile.label(file);
        };
    }
}
