package sunbeam.precompute.units;

/** Text that is not a length; the message shows the text and what to write instead. */
public final class LengthFormatException extends IllegalArgumentException {
    public LengthFormatException(String message) {
        super(message);
    }
}
