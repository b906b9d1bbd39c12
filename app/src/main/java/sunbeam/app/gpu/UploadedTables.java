package sunbeam.app.gpu;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.TableArray;

/** A method's tables in graphics memory, for any program that includes the method. Owns its textures. */
public final class UploadedTables implements AutoCloseable {
    private final RenderContext context;
    private final ShaderTables tables;
    private final Map<String, Texture> textures = new HashMap<>();

    private UploadedTables(RenderContext context, ShaderTables tables) {
        this.context = context;
        this.tables = tables;
    }

    /**
     * Uploads tables, layer by layer.
     *
     * @throws jrtr.GraphicsException if the device has no room for them
     */
    public static UploadedTables upload(RenderContext context, ShaderTables tables) {
        UploadedTables uploaded = new UploadedTables(context, tables);
        try {
            tables.arrays().forEach(uploaded::upload);
            return uploaded;
        } catch (RuntimeException | Error failure) {
            uploaded.close();
            throw failure;
        }
    }

    private void upload(TableArray array) {
        ArrayLayout layout = array.layout();
        FloatTexture texture = context.createFloatTexture(layout.sampler(), spec(layout));
        textures.put(layout.sampler(), texture);
        for (int layer = 0; layer < layout.layers(); layer++) {
            texture.uploadLayer(layer, array.layer(layer));
        }
    }

    private static FloatTexture.Spec spec(ArrayLayout layout) {
        FloatTexture.Format format = format(layout.channels());
        FloatTexture.Spec spec = layout.kind() == ArrayLayout.Kind.LAYERED
                ? FloatTexture.Spec.array(layout.width(), layout.height(), layout.layers(), format)
                : FloatTexture.Spec.flat(layout.width(), layout.height(), format);
        return layout.reading() == ArrayLayout.Reading.LINEAR ? spec.with(FloatTexture.Filter.LINEAR) : spec;
    }

    private static FloatTexture.Format format(int channels) {
        return switch (channels) {
            case 1 -> FloatTexture.Format.R32F;
            case 2 -> FloatTexture.Format.RG32F;
            case 4 -> FloatTexture.Format.RGBA32F;
            default -> throw new IllegalArgumentException("no texture has " + channels + " channels");
        };
    }

    /**
     * Compiles a program that includes the method and sets the method's uniforms. The caller closes the program.
     *
     * @param fragment file in shaders/ that includes the method
     */
    public ShaderProgram program(String fragment) {
        return program(fragment, Map.of());
    }

    public ShaderProgram program(String fragment, Map<String, String> furtherDefines) {
        Map<String, String> defines = new HashMap<>(tables.defines());
        defines.put("METHOD", tables.shader());
        defines.putAll(furtherDefines);
        ShaderProgram program =
                context.createFullScreenProgram(Shaders.library().load(fragment, defines));
        try {
            tables.reals().forEach(program::set);
            tables.integers().forEach(program::set);
            return program;
        } catch (RuntimeException failure) {
            program.close();
            throw failure;
        }
    }

    public Map<String, Texture> textures() {
        return textures;
    }

    /**
     * Returns the number of DFT bins per cycle per meter along x and y, which is the patch's width and height in meters; empty if the
     * method's tables have no DFT bins.
     */
    public Optional<double[]> binsPerFrequency() {
        float[] rounded = tables.reals().get("tablePeriod");
        float[] rest = tables.reals().get("tablePeriodRest");
        return rounded == null || rest == null
                ? Optional.empty()
                : Optional.of(new double[] {(double) rounded[0] + rest[0], (double) rounded[1] + rest[1]});
    }

    /** Returns the standard deviation of the coherence window in meters. */
    public double windowSigma() {
        return tables.windowSigma();
    }

    @Override
    public void close() {
        textures.values().forEach(Texture::close);
    }
}
