package sunbeam.app.commands.failure;

import java.util.List;
import java.util.Locale;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** One line for a command line that cannot be understood: what is wrong, what may have been meant, where to read on. */
final class UsageMistake {
    private UsageMistake() {}

    static String message(ParameterException mistake) {
        String command = mistake.getCommandLine().getCommandSpec().qualifiedName();
        return what(mistake) + "; see " + command + " --help";
    }

    private static String what(ParameterException mistake) {
        if (!(mistake instanceof UnmatchedArgumentException unmatched)) {
            return lowerFirst(withoutFullStop(mistake.getMessage()));
        }
        boolean commandExpected = !unmatched.isUnknownOption()
                && !mistake.getCommandLine().getSubcommands().isEmpty();
        String kind = unmatched.isUnknownOption() ? "option" : commandExpected ? "command" : "argument";
        List<String> suggestions = unmatched.getSuggestions();
        String meant = suggestions.isEmpty() ? "" : " (did you mean " + String.join(" or ", suggestions) + "?)";
        return "unknown " + kind + " '" + unmatched.getUnmatched().get(0) + "'" + meant;
    }

    private static String withoutFullStop(String text) {
        return text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
    }

    private static String lowerFirst(String text) {
        return text.substring(0, 1).toLowerCase(Locale.ROOT) + text.substring(1);
    }
}
