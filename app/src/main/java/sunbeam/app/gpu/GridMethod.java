package sunbeam.app.gpu;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import jrtr.Binding;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.resample.AmplitudeFields;
import sunbeam.precompute.resample.InterpolationDesign;
import sunbeam.precompute.resample.PowerFields;
import sunbeam.precompute.table.FourierTable;

/** Method {@code full} over windowed, resampled spectra (shaders/method/full_grid.glsl). */
final class GridMethod implements DiffractionMethod {
    // Linear interpolation between so many weights of the kernel errs by 4e-9. On a skirt, the outermost tap meets a sample
    // that is a thousand times brighter than what it is for.
    private static final int KERNEL_SAMPLES = 16384;

    private final Plan plan;
    private final Sampling.Grid sampling;
    private final FourierTable table;
    private final MethodUse use;
    private final CieTable cie;
    private final Textures textures;
    private final List<GridTextures> grids = new ArrayList<>();
    private final Map<String, String> defines = new TreeMap<>();

    /** Resamples and uploads what the use needs. */
    GridMethod(
            RenderContext context, Plan plan, Sampling.Grid sampling, FourierTable table, MethodUse use, CieTable cie) {
        this.plan = plan;
        ErrorBudget budget = new ErrorBudget(plan.tolerance());
        // Of single wavelengths both averages are wanted.
        this.sampling = use == MethodUse.SPECTRAL ? sampling.with(budget.interpolation(Average.ENSEMBLE)) : sampling;
        this.table = table;
        this.use = use;
        this.cie = cie;
        this.textures = new Textures(context);
        defines.put("COHERENT_LAYERS", "0");
        defines.put("ENSEMBLE_LAYERS", "0");
        boolean ensemble = plan.average() == Average.ENSEMBLE;
        if (use == MethodUse.SPECTRAL || !ensemble) {
            AmplitudeFields fields = new AmplitudeFields(table, plan.expansion(), plan.origin());
            double sigma = plan.window().sigmaFrequency();
            add(new GridTextures("coherent", plan, this.sampling, table, fields, sigma), "COHERENT_LAYERS");
        }
        if (use == MethodUse.SPECTRAL || ensemble) {
            PowerFields fields = new PowerFields(table, plan.expansion(), budget.powerBasis());
            // The square of a Gaussian is narrower by sqrt(2).
            double sigma = plan.window().sigmaFrequency() / Math.sqrt(2);
            add(new GridTextures("ensemble", plan, this.sampling, table, fields, sigma), "ENSEMBLE_LAYERS");
        }
        InterpolationDesign design = this.sampling.interpolation();
        textures.addInterpolationKernel(KERNEL_SAMPLES, design.taps(), design::kernel);
        textures.addCieWeights(cie);
    }

    private void add(GridTextures grid, String layersName) {
        grid.addCoefficients(textures);
        if (use == MethodUse.SPECTRAL) {
            grid.addPoint(textures, plan.range());
        } else {
            grid.addPoint(textures, centre());
            grid.addRays(textures);
        }
        grid.define(defines, layersName);
        grids.add(grid);
    }

    /** The directions near the specular one, where both axes are interpolated. */
    private VisibleRange centre() {
        double reach = sampling.centreReach();
        VisibleRange range = plan.range();
        return new VisibleRange(-reach, reach, -reach, reach, range.minimumW(), range.maximumW());
    }

    @Override
    public Map<String, String> defines() {
        Map<String, String> all = MethodDefines.of("full_grid", plan.average());
        all.putAll(defines);
        all.put("TAPS", Integer.toString(sampling.interpolation().taps()));
        return all;
    }

    @Override
    public void setUniforms(ShaderProgram program) {
        program.set("heightHalfRange", (float) table.scale().halfRange());
        grids.forEach(grid -> grid.setUniforms(program));
        if (use == MethodUse.COLOUR) {
            grids.get(0).setRayUniforms(program);
            program.set("gridNodeStep", (float) sampling.nodeStep());
            program.set("gridLargestStride", sampling.largestStride());
            program.set("gridCentreReach", (float) sampling.centreReach());
            program.set("gridCentreNodes", sampling.fewestNodes());
            program.set("cieWhite", Textures.cieWhite(cie));
        }
    }

    @Override
    public List<Binding> bindings() {
        return textures.bindings();
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
