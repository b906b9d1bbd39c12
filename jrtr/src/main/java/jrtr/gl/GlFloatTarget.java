package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.lang.reflect.Array;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import jrtr.ContextLimits;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.GraphicsException;
import jrtr.Texture;
import jrtr.Tile;
import jrtr.Wrap;

/** A framebuffer object with textures and, if asked for, a depth renderbuffer. */
final class GlFloatTarget extends GlResource implements FloatTarget {
    private static final int CHANNELS = 4;
    // 0xAARRGGBB.
    private static final int SCREEN_COLORS = GL3.GL_UNSIGNED_INT_8_8_8_8_REV;

    private final FloatTargetSpec spec;
    private final List<GlAttachment> colors = new ArrayList<>();
    private final int[] framebuffer = new int[1];
    private final int[] depthBuffer = new int[1];

    private GlFloatTarget(GlDevice device, String label, FloatTargetSpec spec) {
        super(device, label);
        this.spec = spec;
    }

    static GlFloatTarget create(GlDevice device, String label, FloatTargetSpec spec) {
        requireAllowed(device, label, spec);
        GL3 gl = device.gl();
        GlFloatTarget target = new GlFloatTarget(device, label, spec);
        try {
            target.allocate(gl);
            return target;
        } catch (RuntimeException failure) {
            target.close();
            throw failure;
        }
    }

    private static void requireAllowed(GlDevice device, String label, FloatTargetSpec spec) {
        ContextLimits limits = device.limits();
        if (spec.width() > limits.targetWidth() || spec.height() > limits.targetHeight()) {
            throw new GraphicsException("target '" + label + "' needs " + spec.width() + " x " + spec.height()
                    + " pixels but this driver allows at most " + limits.targetWidth() + " x " + limits.targetHeight()
                    + " ("
                    + device.info().renderer() + ")");
        }
        if (spec.colors() > limits.colors()) {
            throw new GraphicsException("target '" + label + "' needs " + spec.colors()
                    + " images but this driver allows at most " + limits.colors() + " ("
                    + device.info().renderer() + ")");
        }
    }

    private void allocate(GL3 gl) {
        gl.glGenFramebuffers(1, framebuffer, 0);
        int[] drawBuffers = new int[spec.colors()];
        for (int color = 0; color < spec.colors(); color++) {
            colors.add(new GlAttachment(this, color, createImage(gl)));
            drawBuffers[color] = GL3.GL_COLOR_ATTACHMENT0 + color;
        }
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer[0]);
        for (GlAttachment color : colors) {
            int point = GL3.GL_COLOR_ATTACHMENT0 + color.index();
            gl.glFramebufferTexture2D(GL3.GL_FRAMEBUFFER, point, GL3.GL_TEXTURE_2D, color.glName(), 0);
        }
        if (spec.depth()) {
            attachDepth(gl);
        }
        gl.glDrawBuffers(drawBuffers.length, drawBuffers, 0);
        int status = gl.glCheckFramebufferStatus(GL3.GL_FRAMEBUFFER);
        if (status != GL3.GL_FRAMEBUFFER_COMPLETE) {
            throw new GraphicsException(
                    "target '" + label() + "' cannot be drawn to on this driver: " + GlNames.framebufferStatus(status));
        }
        device().check(gl, "taking memory for '" + label() + "'");
    }

    private int createImage(GL3 gl) {
        TextureMemory memory = new TextureMemory(device(), label());
        int name = memory.create(gl, GL3.GL_TEXTURE_2D, Wrap.CLAMP);
        try {
            gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_MIN_FILTER, GL3.GL_NEAREST);
            gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_MAG_FILTER, GL3.GL_NEAREST);
            gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_MAX_LEVEL, 0);
            long pixels = (long) spec.width() * spec.height();
            // In the order in which colors are read back: a copy then, without a look at each.
            boolean screen = spec.format() == FloatTargetSpec.Format.RGBA8;
            memory.allocate(
                    gl,
                    GL3.GL_TEXTURE_2D,
                    screen ? GL3.GL_RGBA8 : GL3.GL_RGBA32F,
                    spec.width(),
                    spec.height(),
                    1,
                    screen ? GL3.GL_BGRA : GL3.GL_RGBA,
                    screen ? SCREEN_COLORS : GL3.GL_FLOAT,
                    (screen ? Integer.BYTES : CHANNELS * Float.BYTES) * pixels);
            return name;
        } catch (RuntimeException failure) {
            gl.glDeleteTextures(1, new int[] {name}, 0);
            throw failure;
        }
    }

    private void attachDepth(GL3 gl) {
        gl.glGenRenderbuffers(1, depthBuffer, 0);
        gl.glBindRenderbuffer(GL3.GL_RENDERBUFFER, depthBuffer[0]);
        gl.glRenderbufferStorage(GL3.GL_RENDERBUFFER, GL3.GL_DEPTH_COMPONENT32F, spec.width(), spec.height());
        gl.glFramebufferRenderbuffer(GL3.GL_FRAMEBUFFER, GL3.GL_DEPTH_ATTACHMENT, GL3.GL_RENDERBUFFER, depthBuffer[0]);
    }

    /** Directs drawing here, to the tile only; the viewport is the whole target, so coordinates are the target's. */
    void bindForDrawing(GL3 gl, Tile tile) {
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer[0]);
        gl.glViewport(0, 0, spec.width(), spec.height());
        gl.glEnable(GL3.GL_SCISSOR_TEST);
        gl.glScissor(tile.x(), bottomOf(tile), tile.width(), tile.height());
    }

    boolean owns(GlTexture texture) {
        return texture instanceof GlAttachment attachment && attachment.owner() == this;
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

    @Override
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

    @Override
    public float[] read(int color) {
        return read(color, Tile.whole(spec.width(), spec.height()));
    }

    @Override
    public float[] read(int color, Tile tile) {
        requireColor(color);
        requireInside(tile);
        float[] pixels = new float[length(tile, CHANNELS)];
        readPixels(color, tile, GL3.GL_RGBA, GL3.GL_FLOAT, FloatBuffer.wrap(pixels));
        turnUpsideDown(pixels, new float[CHANNELS * tile.width()]);
        return pixels;
    }

    @Override
    public int[] readColors(int color, Tile tile) {
        requireColor(color);
        requireInside(tile);
        int[] pixels = new int[length(tile, 1)];
        readPixels(color, tile, GL3.GL_BGRA, SCREEN_COLORS, IntBuffer.wrap(pixels));
        turnUpsideDown(pixels, new int[tile.width()]);
        return pixels;
    }

    private int length(Tile tile, int channels) {
        long length = tile.pixels() * channels;
        if (length > Integer.MAX_VALUE - 8) {
            throw new GraphicsException("reading " + tile.width() + " x " + tile.height() + " pixels of '" + label()
                    + "' needs " + length + " values, more than an array has; read smaller tiles");
        }
        return (int) length;
    }

    private void readPixels(int color, Tile tile, int format, int type, Buffer pixels) {
        GL3 gl = gl();
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer[0]);
        gl.glReadBuffer(GL3.GL_COLOR_ATTACHMENT0 + color);
        // Drawing ends before the copy begins: the copy pins the array, and with it the garbage collector.
        gl.glFinish();
        gl.glPixelStorei(GL3.GL_PACK_ALIGNMENT, 4);
        gl.glReadPixels(tile.x(), bottomOf(tile), tile.width(), tile.height(), format, type, pixels);
        device().check(gl, "reading '" + label() + "'");
    }

    /** @param row room for one, an array of the same type */
    private static void turnUpsideDown(Object pixels, Object row) {
        int length = Array.getLength(row);
        for (int top = 0, bottom = Array.getLength(pixels) - length; top < bottom; top += length, bottom -= length) {
            System.arraycopy(pixels, top, row, 0, length);
            System.arraycopy(pixels, bottom, pixels, top, length);
            System.arraycopy(row, 0, pixels, bottom, length);
        }
    }

    private void requireColor(int color) {
        if (color < 0 || color >= spec.colors()) {
            throw new IllegalArgumentException(
                    "target '" + label() + "' has images 0 to " + (spec.colors() - 1) + ", not " + color);
        }
    }

    @Override
    public Texture texture(int color) {
        requireColor(color);
        gl();
        return colors.get(color);
    }

    @Override
    public FloatTargetSpec spec() {
        return spec;
    }

    @Override
    void delete(GL3 gl) {
        gl.glDeleteFramebuffers(1, framebuffer, 0);
        gl.glDeleteRenderbuffers(1, depthBuffer, 0);
        for (GlAttachment color : colors) {
            gl.glDeleteTextures(1, new int[] {color.glName()}, 0);
        }
    }
}
