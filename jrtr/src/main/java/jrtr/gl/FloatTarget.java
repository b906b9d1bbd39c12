package jrtr.gl;

import com.jogamp.opengl.FBObject;
import com.jogamp.opengl.GL3;
import java.lang.reflect.Array;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import jrtr.GraphicsException;
import jrtr.Tile;
import jrtr.gl.RenderContext.ContextInfo;

/**
 * Render target with color attachments in RGBA32F (or RGBA8 for the screen) and optional depth, without blending and without sRGB
 * conversion. Contents are undefined until cleared or drawn. Arrays read back have row 0 at the TOP; {@code gl_FragCoord} counts rows from
 * the bottom, and the fragment at {@code (x + 0.5, y + 0.5)} is in row {@code height - 1 - y} of the array.
 */
public final class FloatTarget extends Resource {
    public enum Format {
        RGBA32F,
        /** Four values of 8 bits for the screen, clamped to [0, 1]. */
        RGBA8
    }

    /**
     * Shape of a render target, each side at least 1 pixel: color images, of which the fragment shader's {@code layout(location = i) out
     * vec4} writes image i, and perhaps a depth image of 32-bit floats.
     */
    public record Spec(int width, int height, int colors, boolean depth, Format format) {
        public Spec(int width, int height, int colors, boolean depth) {
            this(width, height, colors, depth, Format.RGBA32F);
        }

        public static Spec color(int width, int height) {
            return new Spec(width, height, 1, false);
        }
    }

    private static final int CHANNELS = 4;
    // Pixel type of ints 0xAARRGGBB, with the format GL_BGRA.
    private static final int SCREEN_COLORS = GL3.GL_UNSIGNED_INT_8_8_8_8_REV;

    private final Spec spec;
    private final int[] framebuffer = new int[1];
    // The color images, then the depth image if there is one.
    private final List<Texture> images = new ArrayList<>();

    FloatTarget(GlDevice device, String label, Spec spec) {
        super(device, label);
        this.spec = spec;
        orClose(() -> allocate(gl()), this::close);
    }

    private FloatTarget allocate(GL3 gl) {
        ContextInfo.Limits limits = device().info().limits();
        if (spec.width() > limits.targetWidth() || spec.height() > limits.targetHeight()) {
            throw device().beyondLimit(
                            "target '" + label() + "' needs " + spec.width() + " x " + spec.height() + " pixels",
                            limits.targetWidth() + " x " + limits.targetHeight());
        }
        if (spec.colors() > limits.colors()) {
            throw device().beyondLimit("target '" + label() + "' needs " + spec.colors() + " images", limits.colors());
        }
        gl.glGenFramebuffers(1, framebuffer, 0);
        int[] drawBuffers = new int[spec.colors()];
        for (int color = 0; color < spec.colors(); color++) {
            drawBuffers[color] = GL3.GL_COLOR_ATTACHMENT0 + color;
            // Screen images use BGRA here and in readColors, so that drivers copy without conversion.
            if (spec.format() == Format.RGBA8) {
                attach(gl, drawBuffers[color], color, GL3.GL_RGBA8, GL3.GL_BGRA, SCREEN_COLORS, Integer.BYTES);
            } else {
                attach(gl, drawBuffers[color], color, GL3.GL_RGBA32F, GL3.GL_RGBA, GL3.GL_FLOAT, 4 * Float.BYTES);
            }
        }
        if (spec.depth()) {
            int internal = GL3.GL_DEPTH_COMPONENT32F;
            attach(gl, GL3.GL_DEPTH_ATTACHMENT, "depth", internal, GL3.GL_DEPTH_COMPONENT, GL3.GL_FLOAT, Float.BYTES);
        }
        gl.glDrawBuffers(drawBuffers.length, drawBuffers, 0);
        int status = gl.glCheckFramebufferStatus(GL3.GL_FRAMEBUFFER);
        if (status != GL3.GL_FRAMEBUFFER_COMPLETE) {
            throw new GraphicsException(
                    "target '" + label() + "' cannot be drawn to on this driver: " + FBObject.getStatusString(status)
                            + "; set LIBGL_ALWAYS_SOFTWARE=1 to use Mesa's software renderer");
        }
        device().check(gl, "allocating '" + label() + "'");
        return this;
    }

    private void attach(GL3 gl, int attachment, Object name, int internal, int format, int type, int pixelBytes) {
        Texture image = new Texture(device(), label() + "[" + name + "]", GL3.GL_TEXTURE_2D);
        images.add(image);
        image.begin(gl, GL3.GL_CLAMP_TO_EDGE, GL3.GL_NEAREST, GL3.GL_NEAREST);
        double bytes = (double) pixelBytes * spec.width() * spec.height();
        image.allocate(gl, internal, spec.width(), spec.height(), 1, format, type, bytes);
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer[0]);
        gl.glFramebufferTexture2D(GL3.GL_FRAMEBUFFER, attachment, GL3.GL_TEXTURE_2D, image.glName(), 0);
    }

    void bindForDrawing(GL3 gl, Tile tile) {
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer[0]);
        gl.glViewport(0, 0, spec.width(), spec.height());
        gl.glEnable(GL3.GL_SCISSOR_TEST);
        gl.glScissor(tile.x(), bottomOf(tile), tile.width(), tile.height());
    }

    boolean owns(Texture texture) {
        return images.contains(texture);
    }

    void requireDepth() {
        if (!spec.depth()) {
            throw new IllegalStateException("target '" + label() + "' has no depth");
        }
    }

    void requireInside(Tile tile) {
        if (!tile.fitsIn(spec.width(), spec.height())) {
            throw new IllegalArgumentException("tile " + tile + " is not inside target '" + label() + "' of "
                    + spec.width() + " x " + spec.height());
        }
    }

    private int bottomOf(Tile tile) {
        return spec.height() - tile.y() - tile.height();
    }

    /** Sets the tile's pixels of every color image to a color, and their depth, if the target has one, to 1 (the far plane). */
    public void clear(Tile tile, float red, float green, float blue, float alpha) {
        requireInside(tile);
        GL3 gl = gl();
        bindForDrawing(gl, tile);
        gl.glColorMask(true, true, true, true);
        float[] value = {red, green, blue, alpha};
        for (int color = 0; color < spec.colors(); color++) {
            gl.glClearBufferfv(GL3.GL_COLOR, color, value, 0);
        }
        if (spec.depth()) {
            gl.glDepthMask(true);
            gl.glClearBufferfv(GL3.GL_DEPTH, 0, new float[] {1}, 0);
        }
        device().check(gl, "clearing '" + label() + "'");
    }

    public float[] read(int color) {
        return read(color, Tile.whole(spec.width(), spec.height()));
    }

    /** Reads part of an image: {@code 4 * tile.width * tile.height} floats, RGBA interleaved, the tile's top row first. */
    public float[] read(int color, Tile tile) {
        float[] pixels = new float[Math.toIntExact(CHANNELS * tile.pixels())];
        readPixels(color, tile, GL3.GL_RGBA, GL3.GL_FLOAT, FloatBuffer.wrap(pixels));
        turnUpsideDown(pixels, new float[CHANNELS * tile.width()]);
        return pixels;
    }

    /** Reads part of an image as 0xAARRGGBB pixels, each channel clamped to [0, 1] and rounded to 8 bits, the tile's top row first. */
    public int[] readColors(int color, Tile tile) {
        int[] pixels = new int[Math.toIntExact(tile.pixels())];
        readPixels(color, tile, GL3.GL_BGRA, SCREEN_COLORS, IntBuffer.wrap(pixels));
        turnUpsideDown(pixels, new int[tile.width()]);
        return pixels;
    }

    private void readPixels(int color, Tile tile, int format, int type, Buffer pixels) {
        requireInside(tile);
        GL3 gl = gl();
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer[0]);
        gl.glReadBuffer(GL3.GL_COLOR_ATTACHMENT0 + color);
        // Wait for drawing before the copy: the copy pins the array, and a pinned array blocks the garbage collector.
        gl.glFinish();
        gl.glPixelStorei(GL3.GL_PACK_ALIGNMENT, 4);
        gl.glReadPixels(tile.x(), bottomOf(tile), tile.width(), tile.height(), format, type, pixels);
        device().check(gl, "reading '" + label() + "'");
    }

    private static void turnUpsideDown(Object pixels, Object row) {
        int length = Array.getLength(row);
        for (int top = 0, bottom = Array.getLength(pixels) - length; top < bottom; top += length, bottom -= length) {
            System.arraycopy(pixels, top, row, 0, length);
            System.arraycopy(pixels, bottom, pixels, top, length);
            System.arraycopy(row, 0, pixels, bottom, length);
        }
    }

    /** Returns an image as a texture (nearest, clamped) for a later draw into another target. Texel row 0 is the bottom row. */
    public Texture texture(int color) {
        gl();
        return images.get(color);
    }

    /** Returns the depth as a texture like {@link #texture}: 0 at the near plane, 1 at the far plane and in cleared pixels. */
    public Texture depth() {
        requireDepth();
        gl();
        return images.get(spec.colors());
    }

    /**
     * Copies another target into this one, with linear filtering. A target of half the width and height (rounded up) is enlarged by 2; lower
     * left corners coincide.
     *
     * @param from target with one color image, in this target's format
     */
    public void fill(FloatTarget from) {
        copy(from, from.spec.width() == spec.width() ? 1 : 2, GL3.GL_COLOR_BUFFER_BIT, GL3.GL_LINEAR);
    }

    /** Copies the depth of a target of the same size. */
    public void copyDepthFrom(FloatTarget from) {
        copy(from, 1, GL3.GL_DEPTH_BUFFER_BIT, GL3.GL_NEAREST);
    }

    private void copy(FloatTarget from, int scale, int what, int filter) {
        GL3 gl = gl();
        from.requireUsableBy(device());
        bindForDrawing(gl, Tile.whole(spec.width(), spec.height()));
        gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, from.framebuffer[0]);
        gl.glReadBuffer(GL3.GL_COLOR_ATTACHMENT0);
        int width = from.spec.width();
        int height = from.spec.height();
        gl.glBlitFramebuffer(0, 0, width, height, 0, 0, scale * width, scale * height, what, filter);
        device().check(gl, "filling '" + label() + "'");
    }

    public Spec spec() {
        return spec;
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteFramebuffers(1, framebuffer, 0);
        images.forEach(Resource::close);
    }
}
