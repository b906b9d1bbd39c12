package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import jrtr.Binding;
import jrtr.ContextInfo;
import jrtr.Faces;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.ImageTexture;
import jrtr.ImageTextureSpec;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.ShaderSource;
import jrtr.Tile;
import jrtr.VertexBuffer;
import jrtr.VertexData;
import jrtr.glsl.EngineShaders;
import jrtr.glsl.FlatUniforms;

/** A render context on any surface. */
final class GlRenderContext implements RenderContext {
    private final GlDevice device;
    private final GlDraw draw;
    private final ShaderSource fullScreenVertices = EngineShaders.library().load("jrtr/fullscreen.vert.glsl");

    private GlRenderContext(GlDevice device) {
        this.device = device;
        this.draw = new GlDraw(device);
    }

    /** Takes over the surface, which ends with the context, or here if there can be none. */
    static GlRenderContext on(OffscreenSurface surface) {
        try {
            return new GlRenderContext(new GlDevice(surface));
        } catch (RuntimeException failure) {
            surface.destroy();
            throw failure;
        }
    }

    @Override
    public ContextInfo info() {
        return device.info();
    }

    @Override
    public ShaderProgram createFullScreenProgram(ShaderSource fragment) {
        if (!info().software()) {
            return GlProgram.create(device, fullScreenVertices, fragment);
        }
        FlatUniforms flat = FlatUniforms.of(fullScreenVertices, fragment);
        return GlProgram.create(device, flat.vertex(), flat.fragment());
    }

    @Override
    public ShaderProgram createMeshProgram(ShaderSource fragment) {
        return GlProgram.create(device, EngineShaders.library().load("jrtr/mesh.vert.glsl"), fragment);
    }

    @Override
    public VertexBuffer createVertexBuffer(String label, VertexData data) {
        return GlVertexBuffer.create(device, label, data);
    }

    @Override
    public FloatTexture createFloatTexture(String label, FloatTextureSpec spec) {
        return GlFloatTexture.create(device, label, spec);
    }

    @Override
    public ImageTexture createImageTexture(String label, ImageTextureSpec spec) {
        return GlImageTexture.create(device, label, spec);
    }

    @Override
    public FloatTarget createFloatTarget(String label, FloatTargetSpec spec) {
        return GlFloatTarget.create(device, label, spec);
    }

    @Override
    public void drawFullScreen(ShaderProgram program, List<Binding> bindings, FloatTarget target, Tile tile) {
        draw.fullScreen((GlProgram) program, bindings, (GlFloatTarget) target, tile);
    }

    @Override
    public void draw(
            ShaderProgram program,
            List<Binding> bindings,
            VertexBuffer mesh,
            Faces faces,
            FloatTarget target,
            Tile tile) {
        draw.mesh((GlProgram) program, bindings, (GlVertexBuffer) mesh, faces, (GlFloatTarget) target, tile);
    }

    @Override
    public void finish() {
        GL3 gl = device.gl();
        gl.glFinish();
        device.check(gl, "finishing");
    }

    @Override
    public boolean isClosed() {
        return device.isClosed();
    }

    @Override
    public void close() {
        device.close();
    }
}
