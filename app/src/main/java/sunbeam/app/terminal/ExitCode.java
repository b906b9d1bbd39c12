package sunbeam.app.terminal;

import java.util.LinkedHashMap;
import java.util.Map;

/** Exit statuses of the process. Scripts rely on these numbers: they never change. */
public enum ExitCode {
    OK(0, "done"),
    INTERNAL_ERROR(1, "internal error: a bug in Sunbeam"),
    USAGE(2, "wrong command line"),
    TOLERANCE_MISSED(
            3,
            "done, but what was compared (--certify, export) misses the tolerance, or the picture can only be a mistake"
                    + " (a mirror, all black, a surface without color)"),
    UNUSABLE_INPUT(4, "input file missing or unusable"),
    NO_GRAPHICS(5, "no usable graphics (display, OpenGL)"),
    CANNOT_WRITE(6, "output cannot be written"),
    SETUP_FAILED(7, "set-up or build failed (before the program starts)"),
    OUTPUT_EXISTS(8, "output exists, and --force is not given"),
    TOO_LITTLE_MEMORY(9, "too little memory for Java"),
    DRIVER_LIMIT(10, "more than graphics drivers can do (steps of a loop, size of a texture)"),
    HUNG_UP(129, "the terminal was closed (SIGHUP)"),
    INTERRUPTED(130, "interrupted (Ctrl-C)"),
    TERMINATED(143, "terminated (SIGTERM)");

    private final int code;
    private final String meaning;

    ExitCode(int code, String meaning) {
        this.code = code;
        this.meaning = meaning;
    }

    public int code() {
        return code;
    }

    public static Map<String, String> table() {
        Map<String, String> table = new LinkedHashMap<>();
        for (ExitCode exitCode : values()) {
            table.put(Integer.toString(exitCode.code), exitCode.meaning);
        }
        return table;
    }
}
