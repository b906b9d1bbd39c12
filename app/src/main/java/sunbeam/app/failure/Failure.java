package sunbeam.app.failure;

import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import jrtr.GraphicsException;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.MemoryException;
import sunbeam.app.terminal.ShutdownHook.CancelledException;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.setting.ChoiceOrigin;
import sunbeam.precompute.setting.Excess;
import sunbeam.precompute.setting.SettingException;

/** Failure as the user sees it: exit code and message of an exception, without the wrappers of thread pools. */
public record Failure(ExitCode code, String message, Throwable cause) {
    /** Exit codes by the type of the exception. A new type needs an entry here, and a message that names the value and the remedy. */
    private static final Map<Class<? extends Throwable>, ExitCode> CODES = Map.ofEntries(
            Map.entry(UsageException.class, ExitCode.USAGE),
            Map.entry(MemoryException.class, ExitCode.TOO_LITTLE_MEMORY),
            Map.entry(OutOfMemoryError.class, ExitCode.TOO_LITTLE_MEMORY),
            Map.entry(SettingException.class, ExitCode.USAGE),
            Map.entry(InputException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(ScanException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(GraphicsException.class, ExitCode.NO_GRAPHICS),
            Map.entry(GraphicsException.BeyondLimit.class, ExitCode.DRIVER_LIMIT),
            Map.entry(OutputException.class, ExitCode.CANNOT_WRITE),
            Map.entry(OutputException.Exists.class, ExitCode.OUTPUT_EXISTS),
            Map.entry(CancelledException.class, ExitCode.INTERRUPTED),
            Map.entry(CancellationException.class, ExitCode.INTERRUPTED),
            Map.entry(InterruptedException.class, ExitCode.INTERRUPTED));

    public static Failure of(Throwable thrown) {
        Throwable cause = unwrapped(thrown);
        ExitCode code = cause instanceof SettingException choice ? codeOf(choice) : codeOf(cause.getClass());
        return new Failure(code, message(cause, code), cause);
    }

    public boolean isBug() {
        return code == ExitCode.INTERNAL_ERROR;
    }

    private static ExitCode codeOf(SettingException choice) {
        ExitCode wrong = choice.place() == ChoiceOrigin.Place.FILE ? ExitCode.UNUSABLE_INPUT : ExitCode.USAGE;
        return choice.excess()
                .map(excess -> excess.isOfMemory() ? ExitCode.TOO_LITTLE_MEMORY : ExitCode.DRIVER_LIMIT)
                .orElse(wrong);
    }

    /** Returns the code of the class or of its nearest known superclass; an unknown exception is a bug. */
    static ExitCode codeOf(Class<?> thrown) {
        for (Class<?> type = thrown; type != null; type = type.getSuperclass()) {
            ExitCode code = CODES.get(type);
            if (code != null) {
                return code;
            }
        }
        return ExitCode.INTERNAL_ERROR;
    }

    private static String message(Throwable cause, ExitCode code) {
        if (cause instanceof OutOfMemoryError) {
            long bytes = Runtime.getRuntime().maxMemory();
            return "out of memory: Java's heap may take " + (bytes >> 20) + " MiB (" + cause.getMessage() + ")"
                    + remedy(2 * bytes) + ", or ask for less";
        }
        if (cause instanceof SettingException choice && choice.excess().isPresent()) {
            Excess excess = choice.excess().get();
            return choice.getMessage() + (excess.isOfMemory() ? remedy(excess.heapBytes()) : "");
        }
        return switch (code) {
            case INTERNAL_ERROR -> "internal error, a bug in Sunbeam: " + cause;
            case INTERRUPTED -> "interrupted";
            default -> cause.getMessage();
        };
    }

    private static String remedy(long heapBytes) {
        return "; allow more with SUNBEAM_JAVA_OPTIONS=-Xmx" + ((heapBytes >> 20) + 1) + "m";
    }

    private static Throwable unwrapped(Throwable thrown) {
        boolean wrapper = thrown instanceof ExecutionException || thrown instanceof CompletionException;
        return wrapper && thrown.getCause() != null ? unwrapped(thrown.getCause()) : thrown;
    }
}
