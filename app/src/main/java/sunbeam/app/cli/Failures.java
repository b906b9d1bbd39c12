package sunbeam.app.cli;

import java.io.PrintWriter;
import java.util.function.BooleanSupplier;
import picocli.CommandLine.ParameterException;
import sunbeam.app.failure.Failure;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.ShutdownHook;

/** Reports a failed command by one line on standard error and an exit code, and by a stack trace with {@code --debug}. */
record Failures(PrintWriter err, BooleanSupplier debug) {
    private static final String BUG_REMEDY = "; run again with --debug and report what it prints";

    int report(Throwable thrown) {
        Failure failure = Failure.of(thrown instanceof ParameterException mistake ? UsageMistake.of(mistake) : thrown);
        ExitCode code = ShutdownHook.isProcessEnding() ? ExitCode.INTERRUPTED : failure.code();
        if (code != ExitCode.INTERRUPTED) {
            err.println(Messages.error(failure.message() + (failure.isBug() ? BUG_REMEDY : "")));
        }
        if (debug.getAsBoolean()) {
            failure.cause().printStackTrace(err);
        }
        err.flush();
        return code.code();
    }
}
