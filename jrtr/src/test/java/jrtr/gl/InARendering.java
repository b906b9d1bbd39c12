package jrtr.gl;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;

@NeedsDisplay
public abstract class InARendering {
    protected static Rendering rendering;

    @BeforeAll
    static void open() {
        rendering = new Rendering();
    }

    @AfterAll
    static void close() {
        rendering.close();
    }
}
