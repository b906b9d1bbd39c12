package sunbeam.app.gpu;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import jrtr.Binding;
import jrtr.Filter;
import jrtr.FloatFormat;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import org.joml.Vector2f;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.table.FourierTable;

/** Method {@code full} over DFT bins (shaders/method/full.glsl): its textures, defines and uniforms. */
public final class FullMethod implements DiffractionMethod {
    private final Plan plan;
    private final FourierTable table;
    private final List<FloatTexture> textures = new ArrayList<>();
    private final List<Binding> bindings = new ArrayList<>();

    /** Uploads the table and the wavelengths. */
    public FullMethod(RenderContext context, Plan plan, FourierTable table) {
        this.plan = plan;
        this.table = table;
        uploadTerms(context);
        uploadWavelengths(context);
        if (table.coefficients() != null) {
            uploadCoefficients(context, table.coefficients());
        }
    }

    private void uploadTerms(RenderContext context) {
        FloatTexture texture = add(
                context,
                "tableTerms",
                FloatTextureSpec.array(table.bandX().count(), table.bandY().count(), table.terms(), FloatFormat.RG32F));
        WindowPhase phase = new WindowPhase(table, plan.origin());
        for (int n = 0; n < table.terms(); n++) {
            texture.uploadLayer(n, phase.interleaved(n));
        }
    }

    private void uploadWavelengths(RenderContext context) {
        WavelengthNodes nodes = plan.wavelengths();
        float[] texels = new float[4 * nodes.count()];
        for (int i = 0; i < nodes.count(); i++) {
            texels[4 * i] = (float) nodes.wavelengths()[i];
            for (int c = 0; c < 3; c++) {
                texels[4 * i + 1 + c] = (float) nodes.weights()[i][c];
            }
        }
        add(context, "wavelengthNodes", FloatTextureSpec.line(nodes.count(), FloatFormat.RGBA32F))
                .upload(texels);
    }

    private void uploadCoefficients(RenderContext context, CoefficientTable coefficients) {
        float[] texels = new float[coefficients.samples() * coefficients.terms()];
        for (int n = 0; n < coefficients.terms(); n++) {
            System.arraycopy(coefficients.values()[n], 0, texels, n * coefficients.samples(), coefficients.samples());
        }
        FloatTextureSpec spec = FloatTextureSpec.flat(coefficients.samples(), coefficients.terms(), FloatFormat.R32F);
        add(context, "expansionCoefficients", spec.with(Filter.LINEAR)).upload(texels);
    }

    private FloatTexture add(RenderContext context, String sampler, FloatTextureSpec spec) {
        FloatTexture texture = context.createFloatTexture(sampler, spec);
        textures.add(texture);
        bindings.add(new Binding(sampler, texture));
        return texture;
    }

    @Override
    public Map<String, String> defines() {
        Map<String, String> defines = new TreeMap<>();
        defines.put("METHOD_FULL", "0");
        defines.put("METHOD", "METHOD_FULL");
        defines.put("EXPANSION_TAYLOR", "0");
        defines.put("EXPANSION_SAMPLED", "1");
        defines.put("EXPANSION", table.coefficients() == null ? "EXPANSION_TAYLOR" : "EXPANSION_SAMPLED");
        defines.put("ANCHOR_FLOOR", "0");
        defines.put("ANCHOR_NEAREST", "1");
        boolean floor = plan.neighbourhood().anchor() == Neighbourhood.Anchor.FLOOR;
        defines.put("ANCHOR", floor ? "ANCHOR_FLOOR" : "ANCHOR_NEAREST");
        defines.put("AVERAGE_COHERENT", "0");
        defines.put("AVERAGE_ENSEMBLE", "1");
        defines.put("AVERAGE", plan.average() == Average.COHERENT ? "AVERAGE_COHERENT" : "AVERAGE_ENSEMBLE");
        defines.put("TERMS", Integer.toString(table.terms()));
        defines.put("RADIUS", Integer.toString(plan.neighbourhood().radius()));
        return defines;
    }

    @Override
    public void setUniforms(ShaderProgram program) {
        CoherenceWindow window = plan.window();
        double width = table.patch().width();
        double height = table.patch().height();
        program.set(
                "tableFirst", new int[] {table.bandX().first(), table.bandY().first()});
        program.set("tablePeriod", new Vector2f((float) width, (float) height));
        program.set("windowSigmaBins", new Vector2f((float) (window.sigmaFrequency() * width), (float)
                (window.sigmaFrequency() * height)));
        program.set("heightHalfRange", (float) table.scale().halfRange());
        if (table.coefficients() != null) {
            program.set("expansionPhaseMap", phaseMap(table.coefficients()));
        }
        program.set("wavelengthCount", plan.wavelengths().count());
    }

    /** Texture coordinate of a phase: the first sample lies at the first texel's centre, the last at the last's. */
    private static Vector2f phaseMap(CoefficientTable coefficients) {
        double scale = (coefficients.samples() - 1.0)
                / coefficients.samples()
                / (coefficients.maximumPhase() - coefficients.minimumPhase());
        return new Vector2f(
                (float) (0.5 / coefficients.samples() - scale * coefficients.minimumPhase()), (float) scale);
    }

    @Override
    public List<Binding> bindings() {
        return List.copyOf(bindings);
    }

    @Override
    public double windowSigma() {
        return plan.window().sigmaMetres();
    }

    @Override
    public void close() {
        textures.forEach(FloatTexture::close);
    }
}
