package sunbeam.app.files.output;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import sunbeam.app.terminal.UsageException;

/** Kind of an output file, by the ending of its name. */
public enum Ending {
    PNG("a PNG picture", "png"),
    PICTURE("a picture", "png pdf svg"),
    LINEAR("linear colors", "npy exr"),
    NPZ("an archive of NumPy arrays", "npz"),
    BSDF("a measured material", "bsdf"),
    CSV("comma-separated text", "csv txt"),
    HTML("a page", "html htm"),
    MESH("a mesh", "obj ply glb"),
    HDF5("an HDF5 file", "h5 hdf5 he5"),
    ROWS("an archive of NumPy arrays or an HDF5 file", "npz h5 hdf5 he5");

    private final String what;
    private final String endings;

    /** @param endings without dot, separated by blanks; the usual one first */
    Ending(String what, String endings) {
        this.what = what;
        this.endings = endings;
    }

    /** Returns what follows the last dot of a file's name, in lower case; empty without a dot. */
    public static String of(Path file) {
        String name = String.valueOf(file.getFileName());
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot + 1).toLowerCase(Locale.ROOT);
    }

    /** Returns the format of a picture with this name: pdf, svg or png, which is that of every other ending. */
    public static String ofPicture(Path file) {
        return PICTURE.isOf(file) ? of(file) : "png";
    }

    /** True if the file's name has an ending of this kind. */
    public boolean isOf(Path file) {
        return known().contains(of(file));
    }

    private List<String> known() {
        return List.of(endings.split(" ", -1));
    }

    /** Refuses an ending that other programs would not read as this content. A name of null, standard output and devices need none. */
    public void require(String option, Path named) {
        if (named == null
                || named.getFileName() == null
                || OutputFolder.isStandardOutput(named)
                || (Files.exists(named) && !Files.isRegularFile(named))) {
            return;
        }
        if (!isOf(named)) {
            List<String> known = known();
            throw new UsageException(option + " " + named + " would be " + what + ", which its name does not say; "
                    + (of(named).isEmpty()
                            ? "call it " + named.getFileName() + "." + known.get(0)
                            : "end it with ." + String.join(" or .", known)));
        }
    }
}
