package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import jrtr.Binding;
import jrtr.Faces;
import jrtr.Tile;

/** Draws triangles; sets all state that the draw depends on. */
final class MeshDraw {
    private final GlDevice device;

    MeshDraw(GlDevice device) {
        this.device = device;
    }

    void draw(
            GlProgram program,
            List<Binding> bindings,
            GlVertexBuffer mesh,
            Faces faces,
            GlFloatTarget target,
            Tile tile) {
        GL3 gl = device.gl();
        program.requireUsableBy(device);
        mesh.requireUsableBy(device);
        target.requireUsableBy(device);
        target.requireInside(tile);
        if (!target.spec().depth()) {
            throw new IllegalStateException(
                    "target '" + target.label() + "' has no depth, which drawing triangles needs");
        }
        program.glSamplers().bind(gl, device, bindings, target);
        program.use(gl);
        target.bindForDrawing(gl, tile);
        setState(gl, faces);
        mesh.draw(gl);
        gl.glDisable(GL3.GL_DEPTH_TEST);
        device.check(gl, "drawing '" + mesh.label() + "'");
    }

    private static void setState(GL3 gl, Faces faces) {
        gl.glDisable(GL3.GL_BLEND);
        if (faces == Faces.FRONT) {
            gl.glEnable(GL3.GL_CULL_FACE);
            gl.glCullFace(GL3.GL_BACK);
            gl.glFrontFace(GL3.GL_CCW);
        } else {
            gl.glDisable(GL3.GL_CULL_FACE);
        }
        gl.glEnable(GL3.GL_DEPTH_TEST);
        gl.glDepthFunc(GL3.GL_LESS);
        gl.glDepthMask(true);
        gl.glColorMask(true, true, true, true);
    }
}
