package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import jrtr.GraphicsException;
import jrtr.VertexData;
import jrtr.VertexData.BoundingSphere;

/** Triangle mesh in graphics memory, uploaded once by {@link RenderContext#createVertexBuffer}. */
public final class VertexBuffer extends Resource {
    private final int triangles;
    private final BoundingSphere bounds;
    private final int[] vertexArray = new int[1];
    private final int[] buffers = new int[5];

    VertexBuffer(GlDevice device, String label, VertexData data) {
        super(device, label);
        this.triangles = data.triangles();
        this.bounds = data.bounds();
        orClose(() -> upload(gl(), data), this::close);
    }

    private VertexBuffer upload(GL3 gl, VertexData data) {
        gl.glGenVertexArrays(1, vertexArray, 0);
        gl.glGenBuffers(buffers.length, buffers, 0);
        gl.glBindVertexArray(vertexArray[0]);
        // The locations are declared in mesh.vert.glsl.
        attribute(gl, 0, 3, data.positions());
        attribute(gl, 1, 3, data.normals());
        attribute(gl, 2, 4, data.tangents());
        attribute(gl, 3, 2, data.textureCoordinates());
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, buffers[4]);
        gl.glBufferData(
                GL3.GL_ELEMENT_ARRAY_BUFFER,
                bytes(data.indices().length),
                IntBuffer.wrap(data.indices()),
                GL3.GL_STATIC_DRAW);
        gl.glBindVertexArray(0);
        device().check(gl, "uploading '" + label() + "'");
        return this;
    }

    private void attribute(GL3 gl, int location, int components, float[] values) {
        gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, buffers[location]);
        gl.glBufferData(GL3.GL_ARRAY_BUFFER, bytes(values.length), FloatBuffer.wrap(values), GL3.GL_STATIC_DRAW);
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribPointer(location, components, GL3.GL_FLOAT, false, 0, 0);
    }

    private long bytes(int numbers) {
        long bytes = 4L * numbers;
        // JOGL copies the array to a direct buffer, whose size in bytes is an int.
        if (bytes > Integer.MAX_VALUE) {
            throw new GraphicsException("'" + label() + "' needs a buffer of " + bytes
                    + " bytes but at most 2147483647 can be uploaded; use a mesh with fewer vertices");
        }
        return bytes;
    }

    void draw(GL3 gl) {
        gl.glBindVertexArray(vertexArray[0]);
        gl.glDrawElements(GL3.GL_TRIANGLES, 3 * triangles, GL3.GL_UNSIGNED_INT, 0);
        gl.glBindVertexArray(0);
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteVertexArrays(1, vertexArray, 0);
        gl.glDeleteBuffers(buffers.length, buffers, 0);
    }

    public BoundingSphere bounds() {
        return bounds;
    }
}
