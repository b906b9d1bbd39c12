package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Failure to write an output; the message names file, reason and remedy. */
public class OutputException extends RuntimeException {
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

    public static OutputException of(Path target, IOException cause) {
        if (OutputFolder.isStandardOutput(target)) {
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

    static void refuseIf(boolean condition, Path target, String problem) {
        if (condition) {
            throw new OutputException("cannot write " + target + ": " + problem);
        }
    }

    /** Image writers wrap the operating system's failure in an "I/O error". */
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
        return reason + (reason.contains("name too long") ? "; choose a shorter name" : "; choose another folder");
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
