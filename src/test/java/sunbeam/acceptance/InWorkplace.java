package sunbeam.acceptance;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** Test whose cases each have a new {@link Workplace}, in the folder {@code root}. */
public abstract class InWorkplace {
    @TempDir
    protected Path root;

    protected Workplace workplace;

    @BeforeEach
    final void makeWorkplace() throws IOException {
        workplace = Workplace.in(root);
    }
}
