package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import jrtr.ContextOptions;
import jrtr.GraphicsException;
import jrtr.RenderContext;
import org.junit.jupiter.api.Test;

@NeedsDisplay
class DebugOutputTest {
    @Test
    void anErrorOfTheDriverSurfacesAtTheNextCheckWithItsOwnWords() {
        OffscreenSurface surface = OffscreenSurface.create(ContextOptions.withDebugOutput());
        try (RenderContext context = GlRenderContext.on(surface, ContextOptions.withDebugOutput())) {
            assumeTrue(context.info().debugOutputActive(), "this driver has no debug output");

            surface.makeCurrent().glBindTexture(0x1234, 0);

            assertThatThrownBy(context::finish)
                    .isInstanceOf(GraphicsException.class)
                    .hasMessageStartingWith("OpenGL reported GL_INVALID_ENUM while finishing (")
                    .hasMessageNotContaining("\n");
            context.finish();
        }
    }

    @Test
    void withoutDebugOutputTheErrorCodeStillSurfaces() {
        OffscreenSurface surface = OffscreenSurface.create(ContextOptions.standard());
        try (RenderContext context = GlRenderContext.on(surface, ContextOptions.standard())) {
            surface.makeCurrent().glEnable(0x1234);

            assertThatThrownBy(context::finish).hasMessage("OpenGL reported GL_INVALID_ENUM while finishing");
            context.finish();
        }
    }
}
