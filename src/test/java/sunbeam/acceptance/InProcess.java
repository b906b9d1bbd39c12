package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import sunbeam.app.terminal.Environment;

/**
 * Runs command lines in this process, whose working folder cannot change: file names are made absolute before, and relative again in the
 * output.
 *
 * @param folder folder of relative file names
 * @param caches folder of the user's caches
 */
record InProcess(Path folder, Path caches) {
    private static final String PATCH = "--patch";
    private static final Set<String> FILE_OPTIONS = Set.of(PATCH, "--output", "--linear", "--directions");

    static {
        // As the program's entry point does: digits are 0 to 9 in every country.
        Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
    }

    SunbeamResult run(String... arguments) throws IOException {
        List<String> before = ownFiles();
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        Environment environment = new Environment(Map.of("XDG_CACHE_HOME", caches.toString()), folder);

        int code = new sunbeam.app.cli.Sunbeam(environment, new PrintWriter(out), new PrintWriter(err))
                .run(withPlaces(arguments));

        assertThat(ownFiles())
                .as("files in the tests' own folder after %s", String.join(" ", arguments))
                .isEqualTo(before);
        return new SunbeamResult("(in process) " + String.join(" ", arguments), code, shorten(out), shorten(err));
    }

    /** Returns the files in the working folder, where a relative output file would be written. */
    private static List<String> ownFiles() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("").toAbsolutePath())) {
            return files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .sorted()
                    .toList();
        }
    }

    private String[] withPlaces(String... arguments) {
        List<String> result = new ArrayList<>();
        String option = "";
        for (String argument : arguments) {
            int equals = argument.indexOf('=');
            if (equals > 0 && FILE_OPTIONS.contains(argument.substring(0, equals))) {
                option = argument.substring(0, equals);
                result.add(option + "=" + place(option, argument.substring(equals + 1)));
            } else {
                result.add(FILE_OPTIONS.contains(option) ? place(option, argument) : argument);
            }
            option = argument;
        }
        return result.toArray(String[]::new);
    }

    /** Returns an absolute file name; the name of a built-in patch stays. */
    private String place(String option, String name) {
        Path file = folder.resolve(name);
        return option.equals(PATCH) && !Files.exists(file) ? name : file.toString();
    }

    private String shorten(StringWriter text) {
        return text.toString().replace(folder + "/", "");
    }
}
