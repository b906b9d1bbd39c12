package sunbeam.app.files.output;

import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;

/** Names for outputs that the user did not name. */
public final class DefaultName {
    private static final int MOST = 10_000;

    private DefaultName() {}

    /**
     * {@code folder/stem.extension}; where that is taken and may not be replaced, the first free one of
     * {@code stem-2.extension}, {@code stem-3.extension} and so on.
     *
     * @param extension without its dot, for example {@code png}
     * @throws OutputException when 10,000 such names are taken
     */
    public static Path choose(Path folder, String stem, String extension, Overwrite overwrite) {
        Path plain = folder.resolve(stem + "." + extension);
        if (overwrite == Overwrite.REPLACE || isFree(plain)) {
            return plain;
        }
        for (int number = 2; number <= MOST; number++) {
            Path numbered = folder.resolve(stem + "-" + number + "." + extension);
            if (isFree(numbered)) {
                return numbered;
            }
        }
        throw new OutputException(
                "cannot write " + plain + ": " + MOST + " such files exist; name one with --output, or add --force");
    }

    private static boolean isFree(Path path) {
        return !Files.exists(path, LinkOption.NOFOLLOW_LINKS);
    }
}
