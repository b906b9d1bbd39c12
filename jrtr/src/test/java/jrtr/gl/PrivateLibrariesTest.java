package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import jrtr.OwnJvm;
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

        OwnJvm outcome = OwnJvm.run(
                Program.class,
                root,
                // JOGL would try these next.
                Map.of("TMPDIR", temporary.toString(), "HOME", root.toString()),
                "-Djava.awt.headless=true",
                "-XX:-UsePerfData",
                "-Djava.io.tmpdir=" + temporary);
        List<String> lines = outcome.output().lines().toList();

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
