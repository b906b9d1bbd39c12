package sunbeam.acceptance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * One start of the launcher, described step by step and then run:
 *
 * <pre>{@code
 * SunbeamResult result = Sunbeam.command("brdf-map", "--size", "64").in(folder).run();
 * }</pre>
 *
 * <p>The program sees this process's environment, save for what {@link #with} and {@link #without} change; standard
 * input is empty. The launcher neither installs nor builds: Maven has just packaged what is tested.
 */
public final class Sunbeam {
    private static final Duration PATIENCE = Duration.ofMinutes(2);

    private final ProcessBuilder builder;

    private Sunbeam(Path launcher, String... arguments) {
        // Restore the signals' defaults, which nohup and background shells replace.
        List<String> command =
                new ArrayList<>(List.of("env", "--default-signal=INT,HUP,QUIT,TERM", launcher.toString()));
        command.addAll(List.of(arguments));
        builder = new ProcessBuilder(command);
        in(repository()).with("SUNBEAM_NO_INSTALL", "1").with("SUNBEAM_NO_BUILD", "1");
    }

    /** Returns a start of this repository's launcher with the given arguments. */
    public static Sunbeam command(String... arguments) {
        return launcher(repository().resolve("sunbeam"), arguments);
    }

    public static Sunbeam launcher(Path launcher, String... arguments) {
        return new Sunbeam(launcher, arguments);
    }

    /**
     * The repository's top folder, the one that holds the launcher.
     *
     * @throws IllegalStateException if the tests run outside the repository
     */
    public static Path repository() {
        Path start = Path.of("").toAbsolutePath();
        for (Path folder = start; folder != null; folder = folder.getParent()) {
            if (Files.isExecutable(folder.resolve("sunbeam")) && Files.exists(folder.resolve("pom.xml"))) {
                return folder;
            }
        }
        throw new IllegalStateException("no launcher in " + start + " nor above: run the tests inside the repository");
    }

    static String example(String name) {
        return repository().resolve("docs/examples/" + name).toString();
    }

    /** Starts it in this folder, which relative paths refer to; without it, in the repository's top folder. */
    public Sunbeam in(Path workingFolder) {
        builder.directory(workingFolder.toFile());
        return this;
    }

    public Sunbeam with(String variable, String value) {
        builder.environment().put(variable, value);
        return this;
    }

    public Sunbeam without(String variable) {
        builder.environment().remove(variable);
        return this;
    }

    /**
     * Runs it to its end.
     *
     * @throws AssertionError if it does not end in time; it is killed then
     * @throws IOException if it cannot be started
     */
    public SunbeamResult run() throws IOException, InterruptedException {
        try (RunningSunbeam running = start()) {
            return running.end(PATIENCE);
        }
    }

    /**
     * Starts it and returns at once. The caller closes the result.
     *
     * @throws IOException if it cannot be started
     */
    public RunningSunbeam start() throws IOException {
        return RunningSunbeam.start(builder);
    }
}
