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
    /** Room for a dozen surfaces. */
    static final long STANDARD = 2_000_000_000;

    /** Of the standard limit, 150 MB: pages of colors of a scan of 1024 x 1024 samples and what they are made of. */
    private static final double SHARE = 0.075;

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

    /** Bytes that one surface's tables may take of a limit: 150 MB at least, more of a limit above the standard one. */
    static long share(long limit) {
        return Math.min(limit, Math.max((long) (SHARE * STANDARD), (long) (SHARE * limit)));
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
