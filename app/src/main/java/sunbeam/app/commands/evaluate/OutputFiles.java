package sunbeam.app.commands.evaluate;

import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StandardOutput;

/** The files of one evaluation: one name, several endings. */
final class OutputFiles {
    private static final int MOST = 10_000;

    private final Path stem;

    private OutputFiles(Path stem) {
        this.stem = stem;
    }

    /** A name that the user gave, or the first free one of {@code chosen}, {@code chosen-2} and so on. */
    static OutputFiles of(Path given, String chosen, List<String> endings, Overwrite overwrite) {
        if (given != null && StandardOutput.isMeant(given)) {
            throw new OutputException(
                    "cannot write several files to standard output: name a file, or ./- for names that begin with -");
        }
        OutputFiles files = given != null ? new OutputFiles(given) : free(chosen, endings, overwrite);
        endings.forEach(ending -> AtomicFile.checkWritable(files.path(ending), overwrite));
        return files;
    }

    private static OutputFiles free(String chosen, List<String> endings, Overwrite overwrite) {
        for (int number = 1; number <= MOST; number++) {
            OutputFiles files = new OutputFiles(Path.of(number == 1 ? chosen : chosen + "-" + number));
            boolean free =
                    endings.stream().noneMatch(ending -> Files.exists(files.path(ending), LinkOption.NOFOLLOW_LINKS));
            if (free || overwrite == Overwrite.REPLACE) {
                return files;
            }
        }
        throw new OutputException(
                "cannot write " + chosen + ": " + MOST + " such files exist; name one with --output, or add --force");
    }

    /** The file with an ending such as {@code .csv}. */
    Path path(String ending) {
        return stem.resolveSibling(stem.getFileName() + ending);
    }
}
