package sunbeam.app.files.cache;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import sunbeam.precompute.shader.ShaderTablesFile;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.table.TableLabel;

/**
 * A table in the cache folder.
 *
 * @param file where it lies
 * @param bytes its length
 * @param lastUsed when it was read or, before that, made
 */
public record CacheEntry(Path file, long bytes, Instant lastUsed) {
    static final String SHADER = "tables";
    /** Of colors that are made as pictures look at them. */
    static final String TILES = "tiles";
    /** Of {@link BlobCache}. */
    static final String BYTES = "bytes";

    private static final int SURFACE_DIGITS = 12;
    private static final int KEY_DIGITS = 32;

    static String name(String surfaceDigest, String keyHash, String ending) {
        return surfaceDigest.substring(0, SURFACE_DIGITS) + "-" + keyHash.substring(0, KEY_DIGITS) + "." + ending;
    }

    /** The name of a file that is no surface's. */
    static String name(String keyHash) {
        return keyHash.substring(0, KEY_DIGITS) + "." + BYTES;
    }

    boolean isTilesOf(String surfaceDigest) {
        String name = file.getFileName().toString();
        return name.startsWith(surfaceDigest.substring(0, SURFACE_DIGITS)) && name.endsWith("." + TILES);
    }

    /** Whether a file's name is one of the program's. */
    static boolean isOne(Path file) {
        return List.of(SHADER, TILES, BYTES).contains(ending(file));
    }

    private static String ending(Path file) {
        String name = file.getFileName().toString();
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /**
     * What it is and for which surface it was made, read from the file, of which no more is checked.
     *
     * @throws TableException when the file does not say it: damaged, of another version, or gone
     */
    public TableLabel label() {
        return switch (ending(file)) {
            case TILES -> TileFile.labelOf(file);
            case BYTES -> BlobCache.label(file);
            default -> ShaderTablesFile.label(file);
        };
    }
}
