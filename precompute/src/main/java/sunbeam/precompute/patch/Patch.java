package sunbeam.precompute.patch;

import java.util.List;

/**
 * A surface, ready for everything that follows.
 *
 * @param name short name for titles and files: the built-in name, or the file's name without folder and extension
 * @param heights levelled heights in metres; no sample is missing
 * @param source where the heights come from and how they were read, for people
 * @param channels a line for each channel of a scan, with its number, name and unit; empty for all else
 * @param notes what was chosen for the user, one line each
 * @param warnings what the user should know, one line each; empty when all is well
 */
public record Patch(
        String name,
        HeightMap heights,
        String source,
        List<String> channels,
        List<String> notes,
        List<String> warnings) {
    public Patch {
        channels = List.copyOf(channels);
        notes = List.copyOf(notes);
        warnings = List.copyOf(warnings);
    }

    /** A surface that comes from no scan. */
    public Patch(String name, HeightMap heights, String source, List<String> warnings) {
        this(name, heights, source, List.of(), List.of(), warnings);
    }

    /** SHA-256 of the height map, for cache keys; see {@link HeightDigest#sha256}. */
    public String digest() {
        return HeightDigest.sha256(heights);
    }
}
