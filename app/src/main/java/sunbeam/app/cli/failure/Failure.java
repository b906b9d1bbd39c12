package sunbeam.app.cli.failure;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import jrtr.GraphicsException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;
import sunbeam.app.files.input.InputException;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputExistsException;
import sunbeam.app.terminal.CancelledException;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.json.JsonException;
import sunbeam.precompute.patch.PatchException;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.text.Similar;
import sunbeam.precompute.units.Decimals;

/**
 * What something thrown means to the user, on the command line and in the viewer alike.
 *
 * @param code the process's exit status where it ends a command; {@link ExitCode#INTERNAL_ERROR} for a bug
 * @param message what failed and what helps
 * @param cause what was thrown, without what thread pools wrap around it
 */
public record Failure(ExitCode code, String message, Throwable cause) {
    /** A new kind of failure needs one line here, and a message that names the value and the remedy. */
    private static final Map<Class<? extends Throwable>, ExitCode> CODES = Map.ofEntries(
            Map.entry(ParameterException.class, ExitCode.USAGE),
            Map.entry(UsageException.class, ExitCode.USAGE),
            Map.entry(SettingException.class, ExitCode.USAGE),
            Map.entry(JsonException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(PatchException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(ScanException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(TableException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(InputException.class, ExitCode.UNUSABLE_INPUT),
            Map.entry(GraphicsException.class, ExitCode.NO_GRAPHICS),
            Map.entry(OutputException.class, ExitCode.CANNOT_WRITE),
            Map.entry(OutputExistsException.class, ExitCode.OUTPUT_EXISTS),
            Map.entry(CancelledException.class, ExitCode.INTERRUPTED),
            Map.entry(InterruptedException.class, ExitCode.INTERRUPTED));

    /** Of anything thrown. */
    public static Failure of(Throwable thrown) {
        Throwable cause = unwrapped(thrown);
        ExitCode code = cause instanceof SettingException choice ? codeOf(choice) : codeOf(cause.getClass());
        return new Failure(code, message(cause, code), cause);
    }

    /** Whether nobody but Sunbeam's makers can help. */
    public boolean isBug() {
        return code == ExitCode.INTERNAL_ERROR && !(cause instanceof OutOfMemoryError);
    }

    /** By the place where the choice was made. */
    private static ExitCode codeOf(SettingException choice) {
        return choice.place() == Origin.Place.FILE ? ExitCode.UNUSABLE_INPUT : ExitCode.USAGE;
    }

    /** By the class or the nearest class above it; anything unknown is a bug. */
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
        if (cause instanceof ParameterException mistake) {
            return UsageMistake.message(mistake);
        }
        if (cause instanceof OutOfMemoryError) {
            long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
            return "out of memory: Java's heap may take " + mebibytes + " MiB (" + cause.getMessage()
                    + "); allow more with SUNBEAM_JAVA_OPTIONS=-Xmx" + 2 * mebibytes + "m, or ask for less";
        }
        if (code == ExitCode.INTERNAL_ERROR) {
            return "internal error, a bug in Sunbeam: " + cause;
        }
        if (code == ExitCode.INTERRUPTED) {
            return "interrupted";
        }
        return cause.getMessage();
    }

    /** Thread pools wrap what their tasks throw. */
    private static Throwable unwrapped(Throwable thrown) {
        boolean wrapper = thrown instanceof ExecutionException || thrown instanceof CompletionException;
        return wrapper && thrown.getCause() != null ? unwrapped(thrown.getCause()) : thrown;
    }

    /** One line for a command line that cannot be understood: what is wrong, what may have been meant, where to read on. */
    private static final class UsageMistake {
        private UsageMistake() {}

        static String message(ParameterException mistake) {
            String command = mistake.getCommandLine().getCommandSpec().qualifiedName();
            return what(mistake) + "; see " + command + " --help";
        }

        private static String what(ParameterException mistake) {
            if (!(mistake instanceof UnmatchedArgumentException unmatched)) {
                return plain(mistake);
            }
            String argument = unmatched.getUnmatched().get(0);
            boolean hasCommands = !mistake.getCommandLine().getSubcommands().isEmpty();
            if (!unmatched.isUnknownOption() && !hasCommands) {
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

        /** Those that a slip of the finger makes of one another; all where there are none. */
        private static List<String> closest(List<String> suggestions, String argument) {
            List<String> close = suggestions.stream()
                    .filter(suggestion -> Similar.are(suggestion, argument.split("=", 2)[0]))
                    .toList();
            return close.isEmpty() ? suggestions : close;
        }

        /** picocli's own words, without names of Java's types. */
        private static String plain(ParameterException mistake) {
            String text = mistake.getMessage();
            String told = text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
            String comma = mistake.getValue() == null ? "" : Decimals.commaRemedy(mistake.getValue());
            String worded = told.replaceFirst("is not an? (?:int|long)$", "is no whole number, such as 512")
                    .replaceFirst("is not an? (?:double|float)$", "is no number, such as 0.5");
            return worded.substring(0, 1).toLowerCase(Locale.ROOT) + worded.substring(1) + comma;
        }
    }
}
