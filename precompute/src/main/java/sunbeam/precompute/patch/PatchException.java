package sunbeam.precompute.patch;

import sunbeam.precompute.text.Quoted;

/** Reports a patch that cannot be used; the message, always one line, names the patch, the wrong value and the remedy. */
public final class PatchException extends RuntimeException {
    public PatchException(String message) {
        super(Quoted.oneLine(message));
    }

    public PatchException(String message, Throwable cause) {
        super(Quoted.oneLine(message), cause);
    }
}
