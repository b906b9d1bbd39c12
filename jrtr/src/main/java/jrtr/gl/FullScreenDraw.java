package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import jrtr.Binding;
import jrtr.ShaderSource;
import jrtr.Tile;
import jrtr.glsl.ShaderLibrary;

/** One triangle over a whole target. Its corners come from the vertex number; OpenGL wants an empty vertex array. */
final class FullScreenDraw extends GlResource {
    private final int[] vertexArray = new int[1];
    private final ShaderSource vertexShader = ShaderLibrary.ofClassPath(
                    FullScreenDraw.class.getClassLoader(), "jrtr/shaders")
            .load("fullscreen.vert.glsl");

    FullScreenDraw(GlDevice device) {
        super(device, "full-screen triangle");
        device.gl().glGenVertexArrays(1, vertexArray, 0);
    }

    ShaderSource vertexShader() {
        return vertexShader;
    }

    void draw(GlProgram program, List<Binding> bindings, GlFloatTarget target, Tile tile) {
        GL3 gl = gl();
        program.requireUsableBy(device());
        target.requireUsableBy(device());
        target.requireInside(tile);
        program.glSamplers().bind(gl, device(), bindings, target);
        program.use(gl);
        target.bindForDrawing(gl, tile);
        gl.glDisable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_BLEND);
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glColorMask(true, true, true, true);
        gl.glBindVertexArray(vertexArray[0]);
        gl.glDrawArrays(GL3.GL_TRIANGLES, 0, 3);
        device().check(gl, "drawing");
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteVertexArrays(1, vertexArray, 0);
    }
}
