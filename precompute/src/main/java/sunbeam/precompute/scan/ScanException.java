package sunbeam.precompute.scan;

import sunbeam.precompute.text.Text;

/** Refusal of a scan file. The message continues the file's name: "ends after 100 bytes; copy it again". */
public class ScanException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public ScanException(String message) {
        super(Text.oneLine(message));
    }

    public ScanException(String message, Throwable cause) {
        super(Text.oneLine(message), cause);
    }

    public static void refuseIf(boolean condition, String message) {
        if (condition) {
            throw new ScanException(message);
        }
    }
}
