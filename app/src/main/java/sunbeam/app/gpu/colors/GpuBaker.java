package sunbeam.app.gpu.colors;

import java.util.HashMap;
import java.util.Map;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.work.Progress;

/** Bakes colors by a method's shader (shaders/colors.frag), in a context of its own, so that any thread may call it. */
record GpuBaker(
        RenderContext context,
        FloatTexture samples,
        FloatTarget target,
        ShaderProgram program,
        Map<String, Texture> textures)
        implements ColorBaker {
    /** Side of a draw: keeps all processors of a software renderer busy, in a short draw. */
    private static final int SIDE = 128;

    /** Fourth component of a used texel; unused ones have 0. */
    private static final float USED = 1;

    /** Uploads a method's tables; throws {@link jrtr.GraphicsException} if the device has no room for them. */
    static GpuBaker of(ShaderTables tables) {
        RenderContext context = RenderContext.offscreen();
        return Resource.orClose(
                () -> {
                    UploadedTables method = UploadedTables.upload(context, tables);
                    FloatTexture samples = context.createFloatTexture(
                            "samples", FloatTexture.Spec.flat(SIDE, SIDE, FloatTexture.Format.RGBA32F));
                    FloatTarget target = context.createFloatTarget("colors", FloatTarget.Spec.color(SIDE, SIDE));
                    Map<String, Texture> textures = new HashMap<>(method.textures());
                    textures.put("samples", samples);
                    return new GpuBaker(context, samples, target, method.program("colors.frag"), textures);
                },
                context::close);
    }

    @Override
    public float[] bake(float[] uvw, Progress token) {
        int count = uvw.length / 3;
        float[] xyz = new float[uvw.length];
        for (int start = 0; start < count; start += SIDE * SIDE) {
            int batch = Math.min(SIDE * SIDE, count - start);
            bakeBatch(uvw, xyz, start, batch);
            token.step(batch);
        }
        return xyz;
    }

    /** Bakes one draw along a Morton curve, so that fragments shaded together read nearly the same texels. */
    private void bakeBatch(float[] uvw, float[] xyz, int start, int count) {
        float[] texels = new float[4 * SIDE * SIDE];
        int rows = 0;
        for (int i = 0; i < count; i++) {
            System.arraycopy(uvw, 3 * (start + i), texels, 4 * texel(i), 3);
            texels[4 * texel(i) + 3] = USED;
            rows = Math.max(rows, LevelBaking.mortonX(i >>> 1) + 1);
        }
        samples.upload(texels);
        // The tile's y counts rows from the top, the texture's from the bottom.
        Tile tile = new Tile(0, SIDE - rows, SIDE, rows);
        context.drawFullScreen(program, textures, target, tile);
        float[] rgba = UploadedTables.requireWholeSums(target.read(0, tile));
        for (int i = 0; i < count; i++) {
            int row = rows - 1 - LevelBaking.mortonX(i >>> 1);
            System.arraycopy(rgba, 4 * (row * SIDE + LevelBaking.mortonX(i)), xyz, 3 * (start + i), 3);
        }
    }

    private static int texel(int number) {
        return LevelBaking.mortonX(number >>> 1) * SIDE + LevelBaking.mortonX(number);
    }

    @Override
    public void close() {
        context.close();
    }
}
