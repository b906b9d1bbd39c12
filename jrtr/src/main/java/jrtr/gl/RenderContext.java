package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.Map;
import jrtr.GraphicsException;
import jrtr.ShaderSource;
import jrtr.Tile;
import jrtr.VertexData;
import jrtr.glsl.FlatUniforms;
import jrtr.glsl.ShaderLibrary;

/**
 * OpenGL context without a window; creates and owns all resources. All methods of a context and of its resources must be called on the
 * thread that created it; on other threads they throw an {@link IllegalStateException}. Several contexts may live on one thread. After
 * closing, only {@code close()}, {@code label()}, {@code spec()} and {@link #info()} may be called. Any method may throw a {@link
 * GraphicsException} when the driver reports an error, and those that create something, when the driver does not allow its size.
 */
public final class RenderContext implements AutoCloseable {
    private final GlDevice device;
    // Empty: the corners of full-screen triangles follow from the vertex number.
    private final int[] noVertices = new int[1];
    private final ShaderSource fullScreenVertices = ShaderLibrary.ofEngine().load("jrtr/fullscreen.vert.glsl");

    public enum Faces {
        BOTH,
        /** Triangles that are counter-clockwise in the picture; for a closed surface seen from outside, these are enough. */
        FRONT
    }

    private enum DepthTest {
        NONE,
        NEARER,
        /** The stored depth is less than 1, the depth of full-screen triangles (the far plane). */
        COVERED
    }

    private RenderContext(GlDevice device) {
        this.device = device;
        device.gl().glGenVertexArrays(1, noVertices, 0);
    }

    /** Throws {@link GraphicsException} if there is no OpenGL 3.3 core, or, on Linux, no X display (Xvfb is enough). */
    public static RenderContext offscreen() {
        GlDevice device = GlDevice.open();
        return Resource.orClose(() -> new RenderContext(device), device::close);
    }

    public ContextInfo info() {
        return device.info();
    }

    /** Compiles a shader for {@link #drawFullScreen}, without inputs. A failure names file and line. */
    public ShaderProgram createFullScreenProgram(ShaderSource fragment) {
        if (!info().software()) {
            return new ShaderProgram(device, fullScreenVertices, fragment);
        }
        FlatUniforms flat =
                FlatUniforms.of(fullScreenVertices, fragment, info().limits().varyings());
        return new ShaderProgram(device, flat.vertex(), flat.fragment());
    }

    /** Compiles a shader for {@link #draw}; its inputs are the outputs of jrtr/mesh.vert.glsl. A failure names file and line. */
    public ShaderProgram createMeshProgram(ShaderSource fragment) {
        return new ShaderProgram(device, ShaderLibrary.ofEngine().load("jrtr/mesh.vert.glsl"), fragment);
    }

    /** Uploads triangles. This and the next methods throw {@link GraphicsException} beyond the driver's limits or memory. */
    public VertexBuffer createVertexBuffer(String label, VertexData data) {
        return new VertexBuffer(device, label, data);
    }

    public FloatTexture createFloatTexture(String label, FloatTexture.Spec spec) {
        return new FloatTexture(device, label, spec);
    }

    /** Uploads a picture with mipmaps: 4 x width x height bytes, red first, row 0 the picture's top. */
    public ImageTexture createImageTexture(
            String label, int width, int height, byte[] rgba, ImageTexture.Encoding encoding) {
        return new ImageTexture(device, label, new ImageTexture.MipLevel(width, height, rgba, encoding));
    }

    public FloatTarget createFloatTarget(String label, FloatTarget.Spec spec) {
        return new FloatTarget(device, label, spec);
    }

    /**
     * Runs the fragment shader once for each pixel of the tile and for no other, without depth test and blending. {@code gl_FragCoord} is
     * relative to the whole target, so tiles that cover a target draw the same picture as one draw.
     *
     * @param textures textures by sampler name, one for each sampler; names follow {@link ShaderProgram}'s rules
     * @param tile must lie inside the target
     */
    public void drawFullScreen(ShaderProgram program, Map<String, Texture> textures, FloatTarget target, Tile tile) {
        fullScreen(program, textures, target, tile, DepthTest.NONE);
    }

    /**
     * Runs the fragment shader as {@link #drawFullScreen} does, but only for pixels whose depth is less than 1; the depth does not change.
     * Software renderers skip the shader for all other pixels, but would run it to the end for fragments that it discards.
     */
    public void drawCovered(ShaderProgram program, Map<String, Texture> textures, FloatTarget target, Tile tile) {
        target.requireDepth();
        fullScreen(program, textures, target, tile, DepthTest.COVERED);
    }

    /** Draws triangles to the tile as {@link #drawFullScreen} does, with depth test; the target has depth. */
    public void draw(
            ShaderProgram program,
            Map<String, Texture> textures,
            VertexBuffer mesh,
            Faces faces,
            FloatTarget target,
            Tile tile) {
        mesh.requireUsableBy(device);
        target.requireDepth();
        GL3 gl = begin(program, textures, target, tile, faces, DepthTest.NEARER);
        mesh.draw(gl);
        device.check(gl, "drawing '" + mesh.label() + "'");
    }

    private void fullScreen(
            ShaderProgram program, Map<String, Texture> textures, FloatTarget target, Tile tile, DepthTest test) {
        GL3 gl = begin(program, textures, target, tile, Faces.BOTH, test);
        gl.glBindVertexArray(noVertices[0]);
        gl.glDrawArrays(GL3.GL_TRIANGLES, 0, 3);
        device.check(gl, "drawing");
    }

    private GL3 begin(
            ShaderProgram program,
            Map<String, Texture> textures,
            FloatTarget target,
            Tile tile,
            Faces faces,
            DepthTest test) {
        GL3 gl = device.gl();
        program.requireUsableBy(device);
        target.requireUsableBy(device);
        target.requireInside(tile);
        program.use(gl, textures, target);
        target.bindForDrawing(gl, tile);
        gl.glDisable(GL3.GL_BLEND);
        gl.glColorMask(true, true, true, true);
        set(gl, GL3.GL_CULL_FACE, faces == Faces.FRONT);
        gl.glCullFace(GL3.GL_BACK);
        gl.glFrontFace(GL3.GL_CCW);
        set(gl, GL3.GL_DEPTH_TEST, test != DepthTest.NONE);
        gl.glDepthFunc(test == DepthTest.COVERED ? GL3.GL_GREATER : GL3.GL_LESS);
        gl.glDepthMask(test == DepthTest.NEARER);
        // Shapes in front of the near plane stay visible.
        set(gl, GL3.GL_DEPTH_CLAMP, test == DepthTest.NEARER);
        return gl;
    }

    private static void set(GL3 gl, int capability, boolean on) {
        if (on) {
            gl.glEnable(capability);
        } else {
            gl.glDisable(capability);
        }
    }

    public void finish() {
        GL3 gl = device.gl();
        gl.glFinish();
        device.check(gl, "finishing");
    }

    @Override
    public void close() {
        device.close();
    }

    /** Driver and device; the renderer is, for example, {@code llvmpipe (LLVM 15.0.6, 256 bits)}. */
    public record ContextInfo(
            String vendor,
            String renderer,
            String version,
            String shadingLanguageVersion,
            boolean software,
            Limits limits) {
        /** Largest sizes and counts: texels along a texture's side, layers, a target's pixels and color images, scalar varyings. */
        public record Limits(
                int textureSize, int arrayLayers, int targetWidth, int targetHeight, int colors, int varyings) {}
    }
}
