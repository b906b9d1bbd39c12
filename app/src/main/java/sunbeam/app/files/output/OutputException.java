package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Thrown if an output file cannot be written; the message names the file, the reason and the remedy. */
public class OutputException extends RuntimeException {
    /** Thrown if an output file exists and may not be replaced. */
    public static final class Exists extends OutputException {
        public Exists(String message) {
            super(message);
        }

        private Exists(String message, Throwable cause) {
            super(message, cause);
        }
    }

    public OutputException(String message) {
        super(message);
    }

    public OutputException(String message, Throwable cause) {
        super(message, cause);
    }

    /** Returns the exception with a message about an operating system's failure to write the target. */
    public static OutputException of(Path target, IOException cause) {
        if (StandardOutput.isMeant(target)) {
            return new OutputException(toStandardOutput(reason(rootOf(cause))), cause);
        }
        String message = "cannot write " + target + ": " + reasonAndRemedy(rootOf(cause));
        return rootOf(cause) instanceof FileAlreadyExistsException
                ? new Exists(message, cause)
                : new OutputException(message, cause);
    }

    public static String toStandardOutput(String reason) {
        return "cannot write to standard output (" + reason
                + "): the program that reads it has ended, or the disk that it goes to is full";
    }

    /** Returns the operating system's own failure, which image writers wrap in an "I/O error". */
    private static IOException rootOf(IOException failure) {
        return failure.getCause() instanceof IOException cause ? rootOf(cause) : failure;
    }

    private static String reasonAndRemedy(IOException cause) {
        if (cause instanceof FileAlreadyExistsException) {
            return "it exists; add --force to overwrite it, or choose another name";
        }
        if (cause instanceof AccessDeniedException) {
            return "permission denied; choose a folder that you may write to";
        }
        if (cause instanceof NoSuchFileException) {
            return "its folder does not exist or takes no files; create it or choose another";
        }
        String reason = reason(cause);
        if (reason.contains("No space left") || reason.contains("quota")) {
            return reason + "; free some space or choose another folder";
        }
        if (reason.contains("name too long")) {
            return reason + "; choose a shorter name";
        }
        return reason + "; choose another folder";
    }

    private static String reason(IOException cause) {
        if (cause instanceof FileSystemException refusal && refusal.getReason() != null) {
            return refusal.getReason();
        }
        return cause.getMessage() != null
                ? cause.getMessage()
                : cause.getClass().getSimpleName();
    }
}
