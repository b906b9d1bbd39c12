package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Libraries of a program started without the launcher, which sets JOGL's folder. */
@NeedsDisplay
class PrivateLibrariesTest {
    @TempDir
    private Path root;

    private Path temporary;

    @BeforeEach
    void makeATemporaryFolder() throws IOException {
        temporary = Files.createDirectory(root.resolve("temporary"));
        Files.setPosixFilePermissions(temporary, PosixFilePermissions.fromString("rwxrwxrwx"));
    }

    /** Prints each library that it loaded from the folder for temporary files, with the mode of that folder's child. */
    static final class Program {
        private Program() {}

        public static void main(String[] arguments) throws IOException {
            try (RenderContext context = RenderContext.offscreen()) {
                Path temporary = Path.of(System.getProperty("java.io.tmpdir")).toRealPath();
                System.out.println("rendered by " + context.info().renderer());
                for (String line : Files.readAllLines(Path.of("/proc/self/maps"))) {
                    int start = line.indexOf('/');
                    if (start > 0
                            && line.endsWith(".so")
                            && Path.of(line.substring(start)).startsWith(temporary)) {
                        Path library = temporary.relativize(Path.of(line.substring(start)));
                        Path top = temporary.resolve(library.getName(0));
                        System.out.println("library "
                                + PosixFilePermissions.toString(Files.getPosixFilePermissions(top)) + " "
                                + Files.getOwner(top).getName().equals(System.getProperty("user.name")) + " "
                                + library);
                    }
                }
            } catch (GraphicsException failure) {
                System.out.println("failed: " + failure.getMessage());
            }
        }
    }

    private List<String> run(Path temporaryFolder) throws IOException, InterruptedException {
        Path output = root.resolve("output");
        ProcessBuilder builder = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.awt.headless=true",
                "-XX:-UsePerfData",
                "-Djava.io.tmpdir=" + temporaryFolder,
                "-cp",
                System.getProperty("java.class.path"),
                Program.class.getName());
        // JOGL would try these next.
        builder.environment().put("TMPDIR", temporaryFolder.toString());
        builder.environment().put("HOME", root.toString());
        Process process = builder.redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .start();
        boolean ended = process.waitFor(30, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).as("the virtual machine ends by itself").isTrue();
        return Files.readAllLines(output, StandardCharsets.UTF_8);
    }

    /** Creates JOGL's default folders in advance; as another user's, if this user is root. */
    @Test
    void nothingIsLoadedFromAFolderThatAnotherUserMade() throws IOException, InterruptedException {
        assumeTrue(Files.exists(Path.of("/proc/self/maps")), "skipped: only Linux tells what was loaded");
        for (String name : List.of("jogamp_0000", "jogamp_0001")) {
            Path foreseen = Files.createDirectories(temporary.resolve(name).resolve("file_cache"));
            for (Path folder : List.of(foreseen, foreseen.getParent())) {
                Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxrwxrwx"));
                if (System.getProperty("user.name").equals("root")) {
                    Files.setAttribute(folder, "unix:uid", 65534); // "nobody" by custom
                }
            }
        }

        List<String> lines = run(temporary);

        assertThat(lines).first().asString().startsWith("rendered by ");
        assertThat(lines.subList(1, lines.size()))
                .isNotEmpty()
                .allMatch(line -> line.startsWith("library rwx------ true jrtr-libraries-"));
        try (Stream<Path> files = Files.walk(temporary)) {
            // Two folders each, and nothing left behind.
            assertThat(files.filter(file -> !file.equals(temporary))).hasSize(4);
        }
    }
}
