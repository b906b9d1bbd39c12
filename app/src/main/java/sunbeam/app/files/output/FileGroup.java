package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import sunbeam.app.terminal.UsageException;

/** Files of one name and several endings: all appear or none, with the lowest number that is free for every ending. */
public record FileGroup(Path stem, List<String> endings, Overwrite overwrite) {
    public FileGroup {
        UsageException.throwIf(
                OutputFolder.isStandardOutput(stem),
                "cannot write several files to standard output: name a file, or ./- for names that begin with -");
    }

    /** Creates the group of a name, which may have one of the endings. A path that names no file is a {@link UsageException}. */
    public static FileGroup named(Path path, List<String> endings, Overwrite overwrite) {
        String name = path.getFileName() == null ? "" : path.getFileName().toString();
        UsageException.throwIf(name.isEmpty(), "--output '" + path + "' names no file; give a name without ending");
        String stem = endings.stream()
                .filter(ending -> name.endsWith(ending) && name.length() > ending.length())
                .findFirst()
                .map(ending -> name.substring(0, name.length() - ending.length()))
                .orElse(name);
        return new FileGroup(path.resolveSibling(stem), endings, overwrite);
    }

    /** Throws OutputException if a file cannot be written. */
    public void checkWritable() {
        endings.forEach(ending -> AtomicFile.checkWritable(path(1, ending), overwrite));
    }

    private Path path(int number, String ending) {
        Path numbered = OutputFolder.numberedAtEnd(stem, number);
        return numbered.resolveSibling(numbered.getFileName() + ending);
    }

    /** Writes contents by ending, of all or some files. Throws OutputException if one cannot be written; then none appears. */
    public List<Path> write(Map<String, StreamContent> contents) {
        Map<String, AtomicFile> files = new LinkedHashMap<>();
        try {
            contents.forEach((ending, content) -> {
                AtomicFile file = AtomicFile.create(path(1, ending), overwrite);
                files.put(ending, file);
                file.fill(content);
            });
            return AtomicFile.commitAll(
                    List.copyOf(files.values()),
                    number -> files.keySet().stream()
                            .map(ending -> path(number, ending))
                            .toList());
        } catch (IOException failure) {
            throw OutputException.of(stem, failure);
        } finally {
            files.values().forEach(AtomicFile::close);
        }
    }
}
