package sunbeam.app.gpu;

import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;

/** Tests that share one render context. */
abstract class InAContext {
    static RenderContext context;

    @BeforeAll
    static void open() {
        context = RenderContexts.offscreen();
    }

    @AfterAll
    static void close() {
        context.close();
    }
}
