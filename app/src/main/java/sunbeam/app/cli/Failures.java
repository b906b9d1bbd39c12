package sunbeam.app.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;
import sunbeam.app.failure.Failure;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Similar;
import sunbeam.precompute.units.Decimals;

/** Reports a failed command by one line on standard error and an exit code, and by a stack trace with {@code --debug}. */
record Failures(PrintWriter err, BooleanSupplier debug) {
    private static final String BUG_REMEDY = "; run again with --debug and report what it prints";

    int report(Throwable thrown) {
        Failure failure = Failure.of(thrown instanceof ParameterException mistake ? worded(mistake) : thrown);
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

    /** Explains why a command line cannot be parsed: the wrong argument, similar names, and the command whose help to read. */
    private static UsageException worded(ParameterException mistake) {
        String command = mistake.getCommandLine().getCommandSpec().qualifiedName();
        UsageException worded = new UsageException(describe(mistake) + "; see " + command + " --help");
        worded.initCause(mistake);
        return worded;
    }

    private static String describe(ParameterException mistake) {
        if (!(mistake instanceof UnmatchedArgumentException unmatched)) {
            return plain(mistake);
        }
        String argument = unmatched.getUnmatched().get(0);
        if (!unmatched.isUnknownOption()
                && mistake.getCommandLine().getSubcommands().isEmpty()) {
            return "unknown argument '" + argument + "'; values follow options, without blanks or in quotes";
        }
        if (unmatched.isUnknownOption() && isOptionOfACommand(mistake, argument)) {
            return "option '" + argument + "' has no command before it; give the command first, then its options";
        }
        String kind = unmatched.isUnknownOption() ? "option" : "command";
        List<String> suggestions = closest(unmatched.getSuggestions(), argument);
        String meant = suggestions.isEmpty() ? "" : " (did you mean " + String.join(" or ", suggestions) + "?)";
        return "unknown " + kind + " '" + argument + "'" + meant;
    }

    private static boolean isOptionOfACommand(ParameterException mistake, String argument) {
        String name = argument.split("=", 2)[0];
        return mistake.getCommandLine().getSubcommands().values().stream()
                .anyMatch(command -> command.getCommandSpec().optionsMap().containsKey(name));
    }

    /** Returns the suggestions that differ from the argument by a typing mistake only; if there is none, all. */
    private static List<String> closest(List<String> suggestions, String argument) {
        List<String> close = suggestions.stream()
                .filter(suggestion -> Similar.are(suggestion, argument.split("=", 2)[0]))
                .toList();
        return close.isEmpty() ? suggestions : close;
    }

    private static String plain(ParameterException mistake) {
        String text = mistake.getMessage();
        String sentence = text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
        String comma = mistake.getValue() == null ? "" : Decimals.commaRemedy(mistake.getValue());
        String worded = sentence.replaceFirst("is not an? (?:int|long)$", "is no whole number, such as 512")
                .replaceFirst("is not an? (?:double|float)$", "is no number, such as 0.5");
        return worded.substring(0, 1).toLowerCase(Locale.ROOT) + worded.substring(1) + comma;
    }
}
