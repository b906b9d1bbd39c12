package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Files of one name and several endings, such as {@code blaze.png}, {@code blaze.csv} and {@code blaze.json}: all appear or
 * none, and where Sunbeam chooses the name, all with the same number, the first of which no ending is taken.
 */
public final class FileGroup {
    private final NumberedNames stems;
    private final List<String> endings;
    private final Overwrite overwrite;

    /**
     * @param stem the files' path without their endings
     * @param endings with their dots
     */
    public FileGroup(Path stem, List<String> endings, Overwrite overwrite) {
        if (StandardOutput.isMeant(stem)) {
            throw new OutputException(
                    "cannot write several files to standard output: name a file, or ./- for names that begin with -");
        }
        this.stems = NumberedNames.ofFolder(stem);
        this.endings = List.copyOf(endings);
        this.overwrite = overwrite;
    }

    /**
     * Tells early whether all could be written now.
     *
     * @throws OutputException when not
     */
    public void checkWritable() {
        endings.forEach(ending -> AtomicFile.checkWritable(path(1, ending), overwrite));
    }

    /** The files that it is, where no name gets a number. */
    public List<Path> plainPaths() {
        return endings.stream().map(ending -> path(1, ending)).toList();
    }

    private Path path(int number, String ending) {
        Path stem = stems.name(number);
        return stem.resolveSibling(stem.getFileName() + ending);
    }

    /**
     * Writes all files.
     *
     * @param contents by ending, some or all of the group's
     * @return where they are, in that order
     * @throws OutputException when one cannot be written; then none appears
     */
    public List<Path> write(Map<String, AtomicFile.StreamContent> contents) {
        if (!endings.containsAll(contents.keySet())) {
            throw new IllegalArgumentException(contents.keySet() + " are not all of " + endings);
        }
        Map<String, AtomicFile> files = new LinkedHashMap<>();
        try {
            contents.forEach((ending, content) -> {
                AtomicFile file = AtomicFile.create(path(1, ending), overwrite);
                files.put(ending, file);
                file.fill(content);
            });
            return overwrite == Overwrite.REPLACE
                    ? files.values().stream().map(AtomicFile::commit).toList()
                    : appear(files);
        } finally {
            files.values().forEach(AtomicFile::close);
        }
    }

    private List<Path> appear(Map<String, AtomicFile> files) {
        int most = overwrite == Overwrite.NUMBER ? NumberedNames.MOST : 1;
        for (int number = 1; number <= most; number++) {
            if (holdAll(files, number)) {
                List<Path> places = new ArrayList<>();
                for (Map.Entry<String, AtomicFile> file : files.entrySet()) {
                    places.add(keep(file.getValue(), path(number, file.getKey())));
                }
                return places;
            }
        }
        throw stems.exhausted();
    }

    /** Whether all names of a number were free, and now are these files'; else none is. */
    private boolean holdAll(Map<String, AtomicFile> files, int number) {
        for (Map.Entry<String, AtomicFile> file : files.entrySet()) {
            Path name = path(number, file.getKey());
            try {
                file.getValue().hold(name);
            } catch (IOException failure) {
                files.values().forEach(AtomicFile::release);
                if (overwrite == Overwrite.NUMBER && failure instanceof FileAlreadyExistsException) {
                    return false;
                }
                throw OutputException.of(name, failure);
            }
        }
        return true;
    }

    private static Path keep(AtomicFile file, Path name) {
        try {
            return file.keep();
        } catch (IOException failure) {
            throw OutputException.of(name, failure);
        }
    }
}
