package sunbeam.acceptance;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** Test of the launcher whose cases each have a new {@link LauncherSandbox}, in the folder {@code folder}. */
abstract class InSandbox {
    static final int SET_UP_FAILED = 7;

    @TempDir
    Path folder;

    LauncherSandbox sandbox;

    @BeforeEach
    final void layOut() throws IOException {
        sandbox = LauncherSandbox.in(folder);
    }
}
