package sunbeam.acceptance;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;

/** A user whom permissions bind: this one, or in place of root, who may read and write every file, user 65534. */
public final class BoundUser {
    // 65534: "nobody" by custom; no file of a test belongs to it.
    private static final List<String> PREFIX =
            List.of("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--");

    private BoundUser() {}

    /**
     * A start by such a user; the test is skipped where root cannot become another, or where that one cannot reach the
     * program.
     *
     * @param root the test's own folder, which is opened to the user
     */
    public static Sunbeam start(Sunbeam start, Path root) throws IOException, InterruptedException {
        if (!System.getProperty("user.name").equals("root")) {
            return start;
        }
        Files.setPosixFilePermissions(root, PosixFilePermissions.fromString("rwxr-xr-x"));
        Path repository = Sunbeam.repository();
        boolean reachable = succeeds("test", "-x", repository.resolve("sunbeam").toString())
                && succeeds("test", "-r", repository.resolve("app/target/lib").toString())
                && succeeds("test", "-x", root.toString());
        assumeTrue(reachable, "skipped: root may do everything, and no other user can start the program here");
        return start.startedBy(PREFIX);
    }

    private static boolean succeeds(String... command) throws InterruptedException {
        List<String> whole = new ArrayList<>(PREFIX);
        whole.addAll(List.of(command));
        try {
            return new ProcessBuilder(whole)
                            .redirectErrorStream(true)
                            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                            .start()
                            .waitFor()
                    == 0;
        } catch (IOException missing) {
            return false; // no setpriv
        }
    }
}
