package sunbeam.app.gpu;

import jrtr.gl.RenderContext;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;

@NeedsDisplay
public abstract class InAContext {
    protected static RenderContext context;

    @BeforeAll
    static void open() {
        context = RenderContext.offscreen();
    }

    @AfterAll
    static void close() {
        context.close();
    }
}
