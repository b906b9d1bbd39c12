package sunbeam.app.cli;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.patch.builtin.BuiltInPatches;

/** Lists the surfaces that the arguments of a command name. A folder stands for its files, in the order of their names. */
final class Surfaces {
    /** Largest size of a descriptor, bytes; the reader of patches refuses larger ones. */
    private static final long LARGEST_DESCRIPTOR = 1 << 20;

    private static final String HEIGHTS = "heights";

    private Surfaces() {}

    static boolean isFolder(String name) {
        return !BuiltInPatches.names().contains(name) && new File(name).isDirectory();
    }

    /** @throws InputException if a name is neither a built-in patch nor an existing file, or if a folder cannot be read or has no file */
    static List<String> of(List<String> names) {
        for (String name : names) {
            if (!BuiltInPatches.names().contains(name) && !new File(name).exists()) {
                throw new InputException("'" + name
                        + "' is neither a built-in patch nor an existing file; a name with blanks needs quotes");
            }
        }
        return names.stream()
                .flatMap(name -> isFolder(name) ? files(Path.of(name)).stream() : Stream.of(name))
                .toList();
    }

    /** Returns a folder's own files without hidden ones, those that a descriptor of the folder names, and other JSON and Markdown. */
    private static List<String> files(Path folder) {
        try (Stream<Path> listed = Files.list(folder)) {
            List<Path> files = listed.filter(file -> Files.isRegularFile(file)
                            && !file.getFileName().toString().matches("(?i)\\..*|.*\\.md")
                            && json(file).map(tree -> tree.has(HEIGHTS)).orElse(true))
                    .sorted()
                    .toList();
            Set<Path> described = new HashSet<>();
            files.forEach(file -> heights(file).ifPresent(described::add));
            if (files.isEmpty()) {
                throw new InputException("the folder " + folder
                        + " has no scan; folders below it and hidden files do not count, name the folder of the scans");
            }
            return files.stream()
                    .filter(file -> !described.contains(file.normalize()))
                    .map(Path::toString)
                    .toList();
        } catch (IOException failure) {
            throw InputException.of(folder, failure);
        }
    }

    /** Returns the file of the heights that a descriptor names; empty if the file is no descriptor. */
    static Optional<Path> heights(Path file) {
        try {
            return json(file)
                    .map(tree -> tree.path(HEIGHTS).textValue())
                    .map(name -> file.resolveSibling(name).normalize());
        } catch (InvalidPathException noDescriptor) {
            return Optional.empty();
        }
    }

    /** Empty if the file is no JSON, or cannot be read: the command reads it later and reports what is wrong. */
    private static Optional<JsonNode> json(Path file) {
        try {
            return file.toString().toLowerCase(Locale.ROOT).endsWith(".json") && Files.size(file) <= LARGEST_DESCRIPTOR
                    ? Optional.of(new ObjectMapper().readTree(file.toFile()))
                    : Optional.empty();
        } catch (IOException broken) {
            return Optional.empty();
        }
    }
}
