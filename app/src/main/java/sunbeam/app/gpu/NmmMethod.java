package sunbeam.app.gpu;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import jrtr.Binding;
import jrtr.Filter;
import jrtr.FloatFormat;
import jrtr.FloatTextureSpec;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import org.joml.Vector2f;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.OrderWeights;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.table.FourierTable;

/**
 * Method {@code nmm}: one wavelength per diffraction order, with the order's width as weight (shaders/method/nmm.glsl) or,
 * as in the thesis, without (nmm_thesis.glsl).
 */
public final class NmmMethod implements DiffractionMethod {
    /** Wavelength steps for directions so near to the specular one that an order covers them all, metres. */
    public static final double WAVELENGTH_STEP = 5e-9;

    // Widest order that one wavelength stands for, in 1 / metre of 1 / lambda: at 500 nm a deviation of 12 nm, a third
    // of
    // the narrowest colour matching function's. At 380 nm a deviation of 7 nm, which steps of 5 nm still resolve.
    private static final double WIDEST_ORDER = 7e4;
    // Largest |(u, v)|: grazing light, grazing view.
    private static final double LARGEST_UV = 2;
    // Of an order farther from the ray less than this is seen.
    private static final double FAINTEST = 1e-3;
    // exp(-1 / (4 sigma^2)) of interference between neighbouring bins that are sigma deviations apart: 2e-3.
    private static final double OVERLAP_SIGMA_BINS = 0.2;

    private final BinsMethod bins;
    private final Plan plan;
    private final FourierTable table;
    private final CieTable cie;
    private final OrderWeights weights;
    private final boolean weighted;
    private final Textures textures;

    /**
     * Uploads the table and the weights.
     *
     * @param plan for DFT bins at fixed wavelengths
     * @param weighted whether orders count by their width; the thesis leaves it out
     * @throws IllegalArgumentException when the plan is for anything else than DFT bins
     */
    public NmmMethod(RenderContext context, Plan plan, FourierTable table, CieTable cie, boolean weighted) {
        if (!(plan.sampling() instanceof Sampling.Bins)) {
            throw new IllegalArgumentException("nmm needs a plan for DFT bins");
        }
        this.plan = plan;
        this.table = table;
        this.cie = cie;
        this.weighted = weighted;
        double sigma = plan.window().sigmaFrequency();
        this.weights = OrderWeights.tabulate(cie, Math.min(sigma / LARGEST_UV, 0.5 * WIDEST_ORDER), WIDEST_ORDER);
        this.bins = new BinsMethod(context, plan, table, cie);
        this.textures = new Textures(context);
        if (weighted) {
            addWeights();
        } else {
            textures.addCieWeights(cie);
        }
    }

    private void addWeights() {
        int texelCount = weights.columns() * weights.rows();
        float[] texels = new float[4 * texelCount];
        for (int i = 0; i < texelCount; i++) {
            System.arraycopy(weights.values(), 3 * i, texels, 4 * i, 3);
        }
        FloatTextureSpec spec = FloatTextureSpec.flat(weights.columns(), weights.rows(), FloatFormat.RGBA32F);
        textures.add("orderWeights", spec.with(Filter.LINEAR)).upload(texels);
    }

    @Override
    public Map<String, String> defines() {
        Map<String, String> defines = bins.defines();
        defines.put("METHOD", weighted ? "nmm" : "nmm_thesis");
        double width = table.patch().width();
        double height = table.patch().height();
        double sigma = plan.window().sigmaFrequency();
        defines.put("ORDERS_OVERLAP", sigma * Math.max(width, height) > OVERLAP_SIGMA_BINS ? "1" : "0");
        // A ray that crosses columns obliquely passes a column's bins at up to this many times their distance to it.
        double reach = Math.sqrt(-Math.log(FAINTEST)) * sigma * Math.hypot(width, height);
        defines.put("ACROSS", Integer.toString((int) Math.max(0, Math.ceil(reach - 0.5))));
        return defines;
    }

    @Override
    public void setUniforms(ShaderProgram program) {
        bins.setUniforms(program);
        if (weighted) {
            program.set("windowSigmaFrequency", (float) plan.window().sigmaFrequency());
            program.set("orderWidest", (float) WIDEST_ORDER);
            program.set("orderPlaceMap", textureMap(weights.minimumPlace(), weights.maximumPlace(), weights.columns()));
            program.set("orderWidthMap", textureMap(weights.minimumWidth(), weights.maximumWidth(), weights.rows()));
        } else {
            program.set("orderStep", (float) WAVELENGTH_STEP);
            program.set("cieWhite", Textures.cieWhite(cie));
        }
    }

    /** Offset and scale to the texture coordinate: the first and the last sample lie at texels' centres. */
    private static Vector2f textureMap(double first, double last, int samples) {
        double scale = (samples - 1.0) / samples / (last - first);
        return new Vector2f((float) (0.5 / samples - scale * first), (float) scale);
    }

    @Override
    public List<Binding> bindings() {
        List<Binding> all = new ArrayList<>(bins.bindings());
        all.addAll(textures.bindings());
        return all;
    }

    @Override
    public double binsPerFrequencyX() {
        return bins.binsPerFrequencyX();
    }

    @Override
    public double binsPerFrequencyY() {
        return bins.binsPerFrequencyY();
    }

    @Override
    public double windowSigma() {
        return bins.windowSigma();
    }

    /** The thesis's form has a white disc in its place, up to the first wavelength that meets a bin. */
    @Override
    public double specularReach() {
        double disc = CieTable.MINIMUM_WAVELENGTH
                / Math.min(table.patch().width(), table.patch().height());
        return weighted ? bins.specularReach() : Math.max(bins.specularReach(), disc);
    }

    @Override
    public void close() {
        textures.close();
        bins.close();
    }
}
