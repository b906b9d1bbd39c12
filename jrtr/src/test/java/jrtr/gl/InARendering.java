package jrtr.gl;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;

/** Tests that share one {@link Rendering}. */
abstract class InARendering {
    static Rendering rendering;

    @BeforeAll
    static void open() {
        rendering = new Rendering();
    }

    @AfterAll
    static void close() {
        rendering.close();
    }
}
