package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import sunbeam.app.terminal.Environment;

/** Folder in which a user runs the program, with its own cache folder. */
public record Workplace(Path folder, Path caches) {
    private static final Set<String> OUTPUTS = Set.of("--output", "--linear");

    static {
        // As the program's entry point does: digits are 0 to 9 in every country.
        Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
    }

    /** Creates both folders, with blanks in their names, in an empty one. */
    public static Workplace in(Path root) throws IOException {
        return new Workplace(
                Files.createDirectories(root.resolve("a folder")), Files.createDirectories(root.resolve("the caches")));
    }

    public Sunbeam command(String commandLine) {
        return equip(Sunbeam.command(commandLine.split(" ", -1)));
    }

    /** Returns a start of the program by a line of bash, in which {@code $SUNBEAM} stands for the launcher. */
    public Sunbeam commandBy(String line, String commandLine) throws IOException {
        Path script = folder.resolveSibling("start by bash");
        Path launcher = Sunbeam.repository().resolve("sunbeam");
        Files.writeString(script, "#!/bin/bash\n" + line.replace("$SUNBEAM", "'" + launcher + "' \"$@\"") + "\n");
        assertThat(script.toFile().setExecutable(true)).isTrue();
        return equip(Sunbeam.launcher(script, commandLine.split(" ", -1)));
    }

    /** Moves a start here. Runs are short, so optimizing compilation would cost more than it saves. */
    public Sunbeam equip(Sunbeam start) {
        return start.in(folder)
                .with("XDG_CACHE_HOME", caches.toString())
                .with("SUNBEAM_JAVA_OPTIONS", "-XX:TieredStopAtLevel=1")
                .without("SUNBEAM_DEBUG");
    }

    /**
     * Runs a command line in this process, at a tenth of the cost of a start. File names refer to the folder, also in the result.
     *
     * @param commandLine words with a blank between them
     * @param values values of the words that contain %s, in turn
     */
    public SunbeamResult here(String commandLine, Object... values) throws IOException {
        Iterator<Object> next = List.of(values).iterator();
        return run(Stream.of(commandLine.split(" ", -1))
                .map(word -> word.contains("%s") ? word.replace("%s", "" + next.next()) : word)
                .toArray(String[]::new));
    }

    private SunbeamResult run(String... arguments) throws IOException {
        List<String> before = names(Path.of(""));
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        Environment environment = new Environment(Map.of("XDG_CACHE_HOME", caches.toString()), folder);

        int code = new sunbeam.app.cli.program.Sunbeam(environment, new PrintWriter(out), new PrintWriter(err))
                .run(withPlaces(arguments));

        assertThat(names(Path.of("")))
                .as("files in the tests' own folder after %s", String.join(" ", arguments))
                .isEqualTo(before);
        return new SunbeamResult("(in process) " + String.join(" ", arguments), code, shorten(out), shorten(err));
    }

    /** Makes names of outputs and of files that exist absolute, as the working folder of this process cannot change. */
    private String[] withPlaces(String... arguments) {
        List<String> result = new ArrayList<>();
        String option = "";
        for (String argument : arguments) {
            Path file = folder.resolve(argument);
            result.add(
                    OUTPUTS.contains(option) || (Files.exists(file) && !argument.isEmpty())
                            ? file.toString()
                            : argument);
            option = argument;
        }
        return result.toArray(String[]::new);
    }

    private String shorten(StringWriter text) {
        return text.toString().replace(folder + "/", "");
    }

    public SunbeamResult succeedHere(String commandLine, Object... values) throws IOException {
        return here(commandLine, values).ended(0);
    }

    public JsonNode json(String commandLine, Object... values) throws IOException {
        return new ObjectMapper().readTree(succeedHere(commandLine, values).stdout());
    }

    public CsvFile reflectance(Object patch, CsvFile directions, String options) throws IOException {
        directions.write(resolve("directions.csv"));
        SunbeamResult result = succeedHere(
                "reflectance --patch %s --directions directions.csv --output reflectance.csv --force " + options,
                patch);
        CsvFile results = CsvFile.read(resolve("reflectance.csv"));
        assertThat(results.size()).as("rows of %s", result).isEqualTo(directions.size());
        return results;
    }

    public JsonNode readJson(String name) throws IOException {
        return new ObjectMapper().readTree(resolve(name).toFile());
    }

    public Path resolve(String name) {
        return folder.resolve(name);
    }

    /** Returns the folder's files including hidden ones, sorted. */
    public List<String> files() throws IOException {
        return names(folder);
    }

    public List<Path> tables() throws IOException {
        Path cache = caches.resolve("sunbeam");
        return names(cache).stream().map(cache::resolve).toList();
    }

    private static List<String> names(Path directory) throws IOException {
        if (!Files.isDirectory(directory)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(directory)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
