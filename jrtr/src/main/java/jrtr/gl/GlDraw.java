package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import jrtr.Faces;
import jrtr.Tile;

/** Draws; sets all state that a draw depends on. */
final class GlDraw extends Resource {
    // Corners of a full-screen triangle come from the vertex number; OpenGL wants an empty vertex array.
    private final int[] noVertices = new int[1];

    GlDraw(GlDevice device) {
        super(device, "full-screen triangle");
        device.gl().glGenVertexArrays(1, noVertices, 0);
    }

    private enum DepthTest {
        NONE,
        NEARER,
        /** Of a full-screen triangle, which lies in the far plane. */
        COVERED
    }

    void fullScreen(ShaderProgram program, List<Binding> bindings, FloatTarget target, Tile tile) {
        fullScreen(begin(program, bindings, target, tile, Faces.BOTH, DepthTest.NONE));
    }

    /** As much, where something lies before the far plane. */
    void covered(ShaderProgram program, List<Binding> bindings, FloatTarget target, Tile tile) {
        requireDepth(target);
        fullScreen(begin(program, bindings, target, tile, Faces.BOTH, DepthTest.COVERED));
    }

    private void fullScreen(GL3 gl) {
        gl.glBindVertexArray(noVertices[0]);
        gl.glDrawArrays(GL3.GL_TRIANGLES, 0, 3);
        device().check(gl, "drawing");
    }

    void mesh(
            ShaderProgram program,
            List<Binding> bindings,
            VertexBuffer mesh,
            Faces faces,
            FloatTarget target,
            Tile tile) {
        mesh.requireUsableBy(device());
        requireDepth(target);
        GL3 gl = begin(program, bindings, target, tile, faces, DepthTest.NEARER);
        mesh.draw(gl);
        device().check(gl, "drawing '" + mesh.label() + "'");
    }

    private static void requireDepth(FloatTarget target) {
        if (!target.spec().depth()) {
            throw new IllegalStateException("target '" + target.label() + "' has no depth, which this draw needs");
        }
    }

    private GL3 begin(
            ShaderProgram program, List<Binding> bindings, FloatTarget target, Tile tile, Faces faces, DepthTest test) {
        GL3 gl = gl();
        program.requireUsableBy(device());
        target.requireUsableBy(device());
        target.requireInside(tile);
        program.glSamplers().bind(gl, device(), bindings, target);
        program.use(gl);
        target.bindForDrawing(gl, tile);
        gl.glDisable(GL3.GL_BLEND);
        gl.glColorMask(true, true, true, true);
        set(gl, GL3.GL_CULL_FACE, faces == Faces.FRONT);
        gl.glCullFace(GL3.GL_BACK);
        gl.glFrontFace(GL3.GL_CCW);
        set(gl, GL3.GL_DEPTH_TEST, test != DepthTest.NONE);
        gl.glDepthFunc(test == DepthTest.COVERED ? GL3.GL_GREATER : GL3.GL_LESS);
        gl.glDepthMask(test == DepthTest.NEARER);
        return gl;
    }

    private static void set(GL3 gl, int capability, boolean on) {
        if (on) {
            gl.glEnable(capability);
        } else {
            gl.glDisable(capability);
        }
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteVertexArrays(1, noVertices, 0);
    }
}
