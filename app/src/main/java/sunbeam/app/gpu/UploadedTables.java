package sunbeam.app.gpu;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import jrtr.GraphicsException;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import sunbeam.precompute.plan.ArrayLayout;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.TableArray;

/** Tables of a method in graphics memory, for any program that includes the method. Owns its textures, by sampler name. */
public record UploadedTables(RenderContext context, ShaderTables tables, Map<String, Texture> textures)
        implements AutoCloseable {
    // LOOPS_CUT of shaders is -1e30: weighted and added to light it stays below, and valid results above.
    private static final float LARGEST_PARTIAL_SUM = -1e20f;

    /** Uploads tables, layer by layer; throws {@link GraphicsException} if the device has no room for them. */
    public static UploadedTables upload(RenderContext context, ShaderTables tables) {
        UploadedTables uploaded = new UploadedTables(context, tables, new HashMap<>());
        return Resource.orClose(
                () -> {
                    tables.arrays().forEach(uploaded::upload);
                    return uploaded;
                },
                uploaded::close);
    }

    private void upload(TableArray array) {
        ArrayLayout layout = array.layout();
        var filter = layout.filtered() ? FloatTexture.Filter.LINEAR : FloatTexture.Filter.NEAREST;
        FloatTexture.Spec spec = new FloatTexture.Spec(
                layout.width(), layout.height(), layout.layers(), layout.layered(), format(layout.channels()), filter);
        FloatTexture texture = context.createFloatTexture(layout.sampler(), spec);
        textures.put(layout.sampler(), texture);
        for (int layer = 0; layer < layout.layers(); layer++) {
            texture.uploadLayer(layer, array.layer(layer));
        }
    }

    private static FloatTexture.Format format(int channels) {
        return switch (channels) {
            case 1 -> FloatTexture.Format.R32F;
            case 2 -> FloatTexture.Format.RG32F;
            default -> FloatTexture.Format.RGBA32F;
        };
    }

    /** Compiles a file of shaders/ that includes the method, and sets the method's uniforms. The caller closes the program. */
    public ShaderProgram program(String fragment) {
        return program(fragment, Map.of());
    }

    public ShaderProgram program(String fragment, Map<String, String> furtherDefines) {
        Map<String, String> defines = new HashMap<>(tables.defines());
        defines.put("METHOD", tables.shader());
        defines.putAll(furtherDefines);
        ShaderProgram program =
                context.createFullScreenProgram(Shaders.library().load(fragment, defines));
        return Resource.orClose(
                () -> {
                    tables.reals().forEach(program::set);
                    tables.integers().forEach(program::set);
                    return program;
                },
                program::close);
    }

    /** Returns the DFT bins per cycle per meter along x and y: the patch's width and height in meters; empty without DFT. */
    public Optional<double[]> binsPerFrequency() {
        float[] rounded = tables.reals().get("tablePeriod");
        float[] rest = tables.reals().get("tablePeriodRest");
        return rounded == null || rest == null
                ? Optional.empty()
                : Optional.of(new double[] {(double) rounded[0] + rest[0], (double) rounded[1] + rest[1]});
    }

    @Override
    public void close() {
        textures.values().forEach(Texture::close);
    }

    /** Returns a shader's results; throws {@link GraphicsException} if the driver cut a sum short (shaders/include/loops.glsl). */
    public static float[] requireWholeSums(float[] results) {
        for (float result : results) {
            if (result < LARGEST_PARTIAL_SUM) {
                throw new GraphicsException.BeyondLimit(
                        "the graphics driver ended a shader's loops before they were done, as Mesa's"
                                + " software renderer does after 65,535 steps, and what they summed is wrong; give a coarser tolerance,"
                                + " method table, a longer coherence length or a smaller neighborhood");
            }
        }
        return results;
    }
}
