package sunbeam.app.gpu.picture;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import sunbeam.app.files.input.InputException;
import sunbeam.app.files.input.PngText;

/** Hash of a picture's parameters in its PNG, which tells whether an existing file is up to date. */
public final class PictureParameters {
    /** Keyword of the PNG text chunk with the hash. */
    public static final String KEYWORD = "Parameters";

    private PictureParameters() {}

    /** Returns the text chunks of a picture with this hash; empty if the file is missing, damaged or has another hash. */
    public static Optional<Map<String, String>> find(Path file, String hash) {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            Map<String, String> text = PngText.read(file);
            return hash.equals(text.get(KEYWORD)) ? Optional.of(text) : Optional.empty();
        } catch (InputException unreadable) {
            // Not this picture; the caller decides whether to replace the file.
            return Optional.empty();
        }
    }
}
