package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jrtr.GraphicsException;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
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

    public static void assertRefused(ThrowingCallable call, String... words) {
        assertThatThrownBy(call).isInstanceOf(GraphicsException.class).hasMessageContainingAll(words);
    }
}
