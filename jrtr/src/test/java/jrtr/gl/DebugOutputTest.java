package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
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

    @Test
    void onlyGraveErrorsThatAreNoShadersAreKept() {
        GlMessages messages = new GlMessages();
        int high = GL2ES2.GL_DEBUG_SEVERITY_HIGH;
        messages.receive(GL2ES2.GL_DEBUG_SOURCE_API, GL2ES2.GL_DEBUG_TYPE_PERFORMANCE, high, "slow");
        messages.receive(GL2ES2.GL_DEBUG_SOURCE_SHADER_COMPILER, GL2ES2.GL_DEBUG_TYPE_ERROR, high, "syntax");
        messages.receive(GL2ES2.GL_DEBUG_SOURCE_API, GL2ES2.GL_DEBUG_TYPE_ERROR, GL2ES2.GL_DEBUG_SEVERITY_LOW, "minor");
        assertThat(messages.takeError()).isNull();

        messages.receive(GL2ES2.GL_DEBUG_SOURCE_API, GL2ES2.GL_DEBUG_TYPE_ERROR, high, " first \n");
        messages.receive(GL2ES2.GL_DEBUG_SOURCE_API, GL2ES2.GL_DEBUG_TYPE_ERROR, high, "second");
        assertThat(messages.takeError()).isEqualTo("first");
        assertThat(messages.takeError()).isNull();
    }

    @Test
    void errorsHaveNames() {
        assertThat(GlNames.error(GL3.GL_OUT_OF_MEMORY)).isEqualTo("GL_OUT_OF_MEMORY");
        assertThat(GlNames.error(0x9999)).contains("0x9999");
    }
}
