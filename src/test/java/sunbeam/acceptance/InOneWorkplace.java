package sunbeam.acceptance;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;

/** Test whose cases share a {@link Workplace}, and so the tables in its cache. Test classes run one after the other. */
public abstract class InOneWorkplace {
    @TempDir
    protected static Path root;

    protected static Workplace workplace;

    @BeforeAll
    protected static void makeWorkplace() throws IOException {
        workplace = Workplace.in(root);
    }
}
