package jrtr;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** What a program printed that ran in a virtual machine of its own. */
public record OwnJvm(int exitCode, String output, String errors) {
    /**
     * Runs a program to its end.
     *
     * @param environment variables to set; an empty value removes a variable
     */
    public static OwnJvm run(Class<?> program, Path folder, Map<String, String> environment, String... options)
            throws IOException, InterruptedException {
        Path output = folder.resolve("output");
        Path errors = folder.resolve("errors");
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(List.of(options));
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), program.getName()));
        ProcessBuilder builder = new ProcessBuilder(command);
        environment.forEach((name, value) -> {
            builder.environment().remove(name);
            if (!value.isEmpty()) {
                builder.environment().put(name, value);
            }
        });
        Process process = builder.redirectOutput(output.toFile())
                .redirectError(errors.toFile())
                .start();
        // A start takes about a second, a draw two; a thread that keeps the machine alive would do so for ever.
        boolean ended = process.waitFor(60, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).as("the virtual machine ends by itself").isTrue();
        return new OwnJvm(
                process.exitValue(),
                Files.readString(output).strip(),
                Files.readString(errors).strip());
    }
}
