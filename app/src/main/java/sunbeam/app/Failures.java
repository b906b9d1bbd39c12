package sunbeam.app;

import java.io.PrintWriter;
import java.util.Map;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.function.BooleanSupplier;
import jrtr.GraphicsException;
import picocli.CommandLine.ParameterException;
import sunbeam.app.cli.CancelledException;
import sunbeam.app.cli.ExitCode;
import sunbeam.app.cli.Messages;
import sunbeam.app.cli.ShutdownHook;
import sunbeam.app.cli.UsageException;
import sunbeam.app.evaluate.NoPeriodException;
import sunbeam.app.input.InputException;
import sunbeam.app.mesh.MeshException;
import sunbeam.app.output.OutputException;
import sunbeam.precompute.json.JsonException;
import sunbeam.precompute.patch.PatchException;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.table.TableException;

/** What a failure says to the user and to scripts: one line on standard error and an exit code, chosen by its type. */
final class Failures {
    /** A new kind of failure needs one line here, and a message that names the value and the remedy. */
    private static final Map<Class<? extends Throwable>, ExitCode> CODES = Map.ofEntries(
            Map.entry(ParameterException.class, ExitCode.USAGE),
            Map.entry(UsageException.class, ExitCode.USAGE),
            Map.entry(JsonException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(PatchException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(TableException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(InputException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(MeshException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(NoPeriodException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(GraphicsException.class, ExitCode.NO_GRAPHICS),
            Map.entry(OutputException.class, ExitCode.CANNOT_WRITE),
            Map.entry(CancelledException.class, ExitCode.INTERRUPTED),
            Map.entry(InterruptedException.class, ExitCode.INTERRUPTED));

    private final PrintWriter err;
    private final BooleanSupplier debug;

    /** @param debug whether stack traces are asked for, known once the command line has been parsed */
    Failures(PrintWriter err, BooleanSupplier debug) {
        this.err = err;
        this.debug = debug;
    }

    /** Says what failed and returns the exit code. Says nothing where the user has interrupted the program. */
    int report(Throwable thrown) {
        Throwable failure = unwrap(thrown);
        ExitCode code = ShutdownHook.isProcessEnding() ? ExitCode.INTERRUPTED : codeOf(failure);
        if (code != ExitCode.INTERRUPTED) {
            err.println(Messages.error(message(failure, code)));
        }
        if (debug.getAsBoolean()) {
            failure.printStackTrace(err);
        }
        err.flush();
        return code.code();
    }

    /** By the failure's class or the nearest class above it; anything unknown is a bug. */
    private static ExitCode codeOf(Throwable failure) {
        if (failure instanceof SettingException choice) {
            return choice.place() == Origin.Place.FILE ? ExitCode.UNUSABLE_INPUT : ExitCode.USAGE;
        }
        for (Class<?> type = failure.getClass(); type != null; type = type.getSuperclass()) {
            ExitCode code = CODES.get(type);
            if (code != null) {
                return code;
            }
        }
        return ExitCode.INTERNAL_ERROR;
    }

    private static String message(Throwable failure, ExitCode code) {
        if (failure instanceof ParameterException mistake) {
            return UsageMistake.message(mistake);
        }
        if (failure instanceof OutOfMemoryError) {
            long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
            return "out of memory: Java's heap may take " + mebibytes + " MiB (" + failure.getMessage()
                    + "); allow more with SUNBEAM_JAVA_OPTIONS=-Xmx" + 2 * mebibytes + "m, or ask for less";
        }
        if (code == ExitCode.INTERNAL_ERROR) {
            return "internal error, a bug in Sunbeam: " + failure
                    + "; run again with --debug and report what it prints";
        }
        return failure.getMessage();
    }

    /** Thread pools wrap what their tasks throw. */
    private static Throwable unwrap(Throwable thrown) {
        boolean wrapper = thrown instanceof ExecutionException || thrown instanceof CompletionException;
        return wrapper && thrown.getCause() != null ? unwrap(thrown.getCause()) : thrown;
    }
}
