package sunbeam.app.files.output;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import sunbeam.app.terminal.UsageException;

/** What the name of an output promises of its content. */
public enum Ending {
    PNG("a PNG picture", "png"),
    NPY("a NumPy array", "npy"),
    CSV("comma-separated text", "csv", "txt"),
    OBJ("a Wavefront mesh", "obj"),
    HDF5("an HDF5 file", "h5", "hdf5", "he5");

    /** Endings that promise something else to whoever opens the file; any other word after a dot promises nothing. */
    private static final Set<String> PROMISES = Set.of(
            "png", "jpg", "jpeg", "jpe", "gif", "bmp", "tif", "tiff", "webp", "exr", "hdr", "pfm", "ppm", "svg", "pdf",
            "npy", "npz", "csv", "tsv", "txt", "xlsx", "ods", "json", "xml", "obj", "ply", "stl", "gltf", "glb", "h5",
            "hdf5", "he5", "mat", "mp4", "zip", "html", "md");

    private final String what;
    private final String usual;
    /** All that fit, between blanks. */
    private final String endings;

    Ending(String what, String... endings) {
        this.what = what;
        this.usual = endings[0];
        this.endings = " " + String.join(" ", endings) + " ";
    }

    /**
     * Refuses a name that promises another format than what will be written.
     *
     * @param option that gave the name
     * @param named null for a name that Sunbeam chooses
     * @throws UsageException for such a name
     */
    public void require(String option, Path named) {
        if (named == null || named.getFileName() == null) {
            return;
        }
        String name = named.getFileName().toString();
        int dot = name.lastIndexOf('.');
        String ending = dot < 0 ? "" : name.substring(dot + 1).toLowerCase(Locale.ROOT);
        if (PROMISES.contains(ending) && !endings.contains(" " + ending + " ")) {
            throw new UsageException(
                    option + " " + named + " would be " + what + " in spite of its name; end it with ." + usual);
        }
    }
}
