package sunbeam.acceptance;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;

/** A user bound by file permissions: the current one or, in place of root, user 65534. */
public final class BoundUser {
    // User 65534, by custom "nobody", owns no file of a test.
    private static final List<String> PREFIX =
            List.of("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--");

    private BoundUser() {}

    /**
     * Returns a start by such a user. The test is skipped if root cannot become that user, or if that user cannot read the program.
     *
     * @param root folder of the test, which is opened to the user
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
