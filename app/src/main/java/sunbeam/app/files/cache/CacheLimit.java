package sunbeam.app.files.cache;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.ByteSize;

/** How large a cache folder may become: its file {@code limit} says it, in bytes. */
final class CacheLimit {
    /** Room for a dozen surfaces. Tables of one that any pair of directions may see take some hundred megabytes. */
    static final long STANDARD = 8L << 30;

    private static final String NAME = "limit";
    private static final Pattern NUMBER = Pattern.compile("\\d{1,18}");
    private static final int LONGEST = 40;

    private CacheLimit() {}

    /**
     * The limit of a folder, bytes; the standard one where none was set.
     *
     * @param warning told in one line where what was set cannot be read
     */
    static long of(Path folder, Consumer<String> warning) {
        Path file = folder.resolve(NAME);
        try {
            String text = Files.size(file) > LONGEST
                    ? ""
                    : new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1).strip();
            if (NUMBER.matcher(text).matches()) {
                return Long.parseLong(text);
            }
            warning.accept(unusable(file, "it is no number of bytes"));
        } catch (NoSuchFileException none) {
            return STANDARD;
        } catch (IOException failure) {
            warning.accept(unusable(file, failure.getMessage()));
        }
        return STANDARD;
    }

    private static String unusable(Path file, String why) {
        return "cannot use " + file + ": " + why + "; the cache may take " + ByteSize.format(STANDARD)
                + " until 'sunbeam cache --limit SIZE' sets it anew";
    }

    /**
     * Sets the limit of a folder that exists.
     *
     * @throws sunbeam.app.files.output.OutputException when it cannot be written
     */
    static void set(Path folder, long bytes) {
        byte[] text = (bytes + "\n").getBytes(StandardCharsets.US_ASCII);
        AtomicFile.write(folder.resolve(NAME), Overwrite.REPLACE, stream -> stream.write(text));
    }
}
