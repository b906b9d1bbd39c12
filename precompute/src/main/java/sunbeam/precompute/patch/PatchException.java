package sunbeam.precompute.patch;

/** A patch (image, descriptor or built-in) that cannot be used; the message names it, the value and the remedy. */
public final class PatchException extends RuntimeException {
    public PatchException(String message) {
        super(message);
    }

    public PatchException(String message, Throwable cause) {
        super(message, cause);
    }
}
