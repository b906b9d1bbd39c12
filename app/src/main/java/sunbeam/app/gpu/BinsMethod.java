package sunbeam.app.gpu;

import java.util.List;
import java.util.Map;
import jrtr.Binding;
import jrtr.FloatFormat;
import jrtr.FloatTexture;
import jrtr.FloatTextureSpec;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import org.joml.Vector2f;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.WindowPhase;

/**
 * Method {@code full} over neighbourhoods of DFT bins: at fixed wavelengths (shaders/method/full_bins.glsl), in equal
 * steps along each direction's ray (full_rays.glsl) or around the middles of orders (full_orders.glsl).
 */
final class BinsMethod implements DiffractionMethod {
    // As in shaders/method/neighbourhood.glsl.
    private static final int UNROLLED_RADIUS = 4;

    private final Plan plan;
    private final FourierTable table;
    private final CieTable cie;
    private final Textures textures;

    /** Uploads the table and the wavelengths. */
    BinsMethod(RenderContext context, Plan plan, FourierTable table, CieTable cie) {
        this.plan = plan;
        this.table = table;
        this.cie = cie;
        this.textures = new Textures(context);
        uploadTerms();
        if (table.coefficients() != null) {
            textures.addCoefficients("expansionCoefficients", table.coefficients(), FloatFormat.R32F);
        }
        if (plan.sampling() instanceof Sampling.Bins bins) {
            textures.addWavelengths(bins.wavelengths());
        } else {
            textures.addCieWeights(cie);
        }
    }

    private void uploadTerms() {
        FloatTexture texture = textures.add(
                "tableTerms",
                FloatTextureSpec.array(table.bandX().count(), table.bandY().count(), table.terms(), FloatFormat.RG32F));
        WindowPhase phase = new WindowPhase(table, plan.origin());
        for (int n = 0; n < table.terms(); n++) {
            texture.uploadLayer(n, interleaved(phase.term(n)));
        }
    }

    private static float[] interleaved(ComplexVector values) {
        float[] result = new float[2 * values.length()];
        for (int i = 0; i < values.length(); i++) {
            result[2 * i] = (float) values.real()[i];
            result[2 * i + 1] = (float) values.imaginary()[i];
        }
        return result;
    }

    private Neighbourhood neighbourhood() {
        if (plan.sampling() instanceof Sampling.Bins bins) {
            return bins.neighbourhood();
        }
        return plan.sampling() instanceof Sampling.Rays rays
                ? rays.neighbourhood()
                : new Neighbourhood(0, Neighbourhood.Anchor.NEAREST);
    }

    private String shader() {
        if (plan.sampling() instanceof Sampling.Bins) {
            return "full_bins";
        }
        return plan.sampling() instanceof Sampling.Rays ? "full_rays" : "full_orders";
    }

    @Override
    public Map<String, String> defines() {
        Map<String, String> defines = MethodDefines.of(shader(), plan.average());
        defines.put("EXPANSION", table.coefficients() == null ? "EXPANSION_TAYLOR" : "EXPANSION_SAMPLED");
        defines.put("ANCHOR_FLOOR", "0");
        defines.put("ANCHOR_NEAREST", "1");
        boolean floor = neighbourhood().anchor() == Neighbourhood.Anchor.FLOOR;
        defines.put("ANCHOR", floor ? "ANCHOR_FLOOR" : "ANCHOR_NEAREST");
        defines.put("TERMS", Integer.toString(table.terms()));
        defines.put("RADIUS", Integer.toString(neighbourhood().radius()));
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
        if (neighbourhood().radius() > UNROLLED_RADIUS) {
            program.set("tableRadius", neighbourhood().radius());
        }
        program.set("heightHalfRange", (float) table.scale().halfRange());
        if (table.coefficients() != null) {
            program.set("expansionPhaseMap", Textures.phaseMap(table.coefficients()));
        }
        if (plan.sampling() instanceof Sampling.Bins bins) {
            program.set("wavelengthCount", bins.wavelengths().count());
        } else if (plan.sampling() instanceof Sampling.Rays rays) {
            program.set("rayNodeStep", (float) rays.nodeStep());
            program.set("rayFewestNodes", rays.fewestNodes());
            program.set("cieWhite", Textures.cieWhite(cie));
        } else if (plan.sampling() instanceof Sampling.Orders orders) {
            program.set("orderReach", (float) orders.reach());
            program.set("orderNodeSpacing", (float) orders.nodeSpacing());
            program.set("orderCutSpacing", (float) orders.cutSpacing());
            program.set("orderLargestStep", (float) orders.largestStep());
            program.set("specularNodes", orders.specularNodes());
            program.set("windowSigmaFrequency", (float) window.sigmaFrequency());
            program.set("cieWhite", Textures.cieWhite(cie));
        }
    }

    @Override
    public List<Binding> bindings() {
        return textures.bindings();
    }

    @Override
    public double binsPerFrequencyX() {
        return table.patch().width();
    }

    @Override
    public double binsPerFrequencyY() {
        return table.patch().height();
    }

    @Override
    public double windowSigma() {
        return plan.window().sigmaMetres();
    }

    @Override
    public void close() {
        textures.close();
    }
}
