package jrtr;

import java.util.List;

/**
 * A device to render with, and the maker and owner of what lives on it. All methods of a context and of its resources
 * must be called on the thread that made it; any other thread gets an {@link IllegalStateException}. Several contexts
 * may live on one thread. Once closed, a context and its resources answer only {@code close()}, {@code isClosed()},
 * {@code label()}, {@code spec()} and {@link #info()}.
 *
 * <p>Any method may throw a {@link GraphicsException} when the driver reports an error.
 */
public interface RenderContext extends AutoCloseable {

    /** Who renders, and what it allows. */
    ContextInfo info();

    /**
     * Compiles a fragment shader for {@link #drawFullScreen}; the vertex shader comes with the engine and has no
     * outputs.
     *
     * @throws ShaderException if that fails, with file and line
     */
    ShaderProgram createFullScreenProgram(ShaderSource fragment);

    /**
     * Compiles a fragment shader for {@link #draw}; the vertex shader comes with the engine (jrtr/mesh.vert.glsl says
     * what it hands over), as do the includes of {@link jrtr.glsl.EngineShaders}.
     *
     * @throws ShaderException if that fails, with file and line
     */
    ShaderProgram createMeshProgram(ShaderSource fragment);

    /**
     * Uploads triangles.
     *
     * @param label its name in messages
     * @throws GraphicsException if the driver has no memory for them
     */
    VertexBuffer createVertexBuffer(String label, VertexData data);

    /**
     * Takes memory for a float texture.
     *
     * @param label its name in messages
     * @throws GraphicsException if the driver does not allow that size; the message has what is needed and what is
     *     allowed
     */
    FloatTexture createFloatTexture(String label, FloatTextureSpec spec);

    /**
     * Takes memory for a picture and its mipmaps.
     *
     * @param label its name in messages
     * @throws GraphicsException if the driver does not allow that size
     */
    ImageTexture createImageTexture(String label, ImageTextureSpec spec);

    /**
     * Takes memory for images to draw to.
     *
     * @param label its name in messages
     * @throws GraphicsException if the driver does not allow that size
     */
    FloatTarget createFloatTarget(String label, FloatTargetSpec spec);

    /**
     * Runs the fragment shader once for each pixel of the tile and for no other, without depth test and blending.
     * {@code gl_FragCoord} is that of the whole target: tiles that cover a target draw the same picture as one draw.
     *
     * @param program every sampler it uses must be bound
     * @param bindings textures by sampler name; names follow {@link ShaderProgram}'s rules
     * @param target where to
     * @param tile must lie inside the target
     */
    void drawFullScreen(ShaderProgram program, List<Binding> bindings, FloatTarget target, Tile tile);

    /**
     * Draws triangles to the tile and to no pixel else, without blending, where they are nearer than what
     * is there. The tile only cuts: tiles that cover a target draw the same picture as one draw, bit for bit.
     *
     * @param program made by {@link #createMeshProgram}; every sampler it uses must be bound
     * @param bindings textures by sampler name
     * @param mesh the triangles
     * @param faces which sides of them
     * @param target where to; must have depth
     * @param tile must lie inside the target
     */
    void draw(
            ShaderProgram program,
            List<Binding> bindings,
            VertexBuffer mesh,
            Faces faces,
            FloatTarget target,
            Tile tile);

    /** Waits until the device has done all that was asked. */
    void finish();

    /** Whether this context has been closed. */
    boolean isClosed();

    /** Frees all resources and the context; harmless when repeated. */
    @Override
    void close();
}
