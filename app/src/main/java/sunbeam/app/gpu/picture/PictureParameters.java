package sunbeam.app.gpu.picture;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import sunbeam.app.files.input.InputException;
import sunbeam.app.files.input.PngText;

/** A hash of all that determines a picture, kept in its PNG: tells whether what is there is what would be drawn. */
public final class PictureParameters {
    /** Keyword of the PNG's text that holds the hash. */
    public static final String KEYWORD = "Parameters";

    private PictureParameters() {}

    /** The texts of a picture with this hash; empty where there is none, or another, or a damaged one, or no PNG. */
    public static Optional<Map<String, String>> find(Path file, String hash) {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            Map<String, String> text = PngText.read(file);
            return hash.equals(text.get(KEYWORD)) ? Optional.of(text) : Optional.empty();
        } catch (InputException unreadable) {
            // Whatever it is, it is not the picture; whether it may be replaced is decided elsewhere.
            return Optional.empty();
        }
    }
}
