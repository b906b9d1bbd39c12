package sunbeam.precompute.files;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import sunbeam.precompute.text.Text;

/** Refusal of an input; the message, always one line, names file, place, value and remedy. */
public final class InputException extends RuntimeException {
    public InputException(String message) {
        super(Text.oneLine(message));
    }

    public InputException(String message, Throwable cause) {
        super(Text.oneLine(message), cause);
    }

    /** Throws an exception with the message if the condition holds. */
    public static void refuseIf(boolean condition, String message) {
        if (condition) {
            throw new InputException(message);
        }
    }

    public static InputException of(Path file, IOException cause) {
        return new InputException("cannot read " + file + ": " + reason(cause), cause);
    }

    /** Its own complaints do not name the file. */
    @FunctionalInterface
    public interface Reading<T> {
        T read() throws IOException;
    }

    /** Reads a file and adds its name to complaints. */
    public static <T> T naming(Path file, Reading<T> reading) {
        try {
            return reading.read();
        } catch (IOException failure) {
            throw of(file, failure);
        } catch (InputException wrong) {
            throw new InputException("cannot use " + file + ": " + wrong.getMessage(), wrong);
        }
    }

    /** Refuses missing and protected files, and folders, pipes and devices, whose reading might never end. */
    public static void requireRegular(Path file) {
        InputException.refuseIf(!Files.exists(file), "cannot read " + file + ": there is no such file; check the name");
        InputException.refuseIf(Files.isDirectory(file), "cannot read " + file + ": it is a folder; name a file in it");
        InputException.refuseIf(
                !Files.isRegularFile(file), "cannot read " + file + ": it is no regular file; copy it to one");
        InputException.refuseIf(
                !Files.isReadable(file), "cannot read " + file + ": permission denied; make it readable");
    }

    public static void requireSmall(Path file, long most, String otherwise) {
        requireRegular(file);
        InputException.refuseIf(naming(file, () -> Files.size(file)) > most, "cannot use " + file + ": " + otherwise);
    }

    private static String reason(IOException cause) {
        if (cause instanceof NoSuchFileException) {
            return "there is no such file; check the name";
        }
        if (cause instanceof AccessDeniedException) {
            return "permission denied; make it readable";
        }
        if (cause instanceof CharacterCodingException) {
            return "it is not text in UTF-8";
        }
        return cause.getMessage() != null
                ? cause.getMessage()
                : cause.getClass().getSimpleName();
    }
}
