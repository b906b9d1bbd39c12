package sunbeam.app.cli.brdfmap;

import static sunbeam.app.scene.SceneSettings.ENERGY;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import jrtr.gl.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.BrdfMapRenderer;
import sunbeam.app.gpu.DiscDirections;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.GpuBaker;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.scene.Energy;
import sunbeam.app.terminal.Progress;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTables.MethodUse;

/**
 * BRDF map of one patch of any material: the sum of one map for each part of its reflection. Shaders compute the standard material; for
 * another, each map is multiplied by a factor that depends only on the pair of directions.
 */
final class MaterialMap {
    private final DiffractionSetup setup;
    private final Method method;
    private final RefractiveIndex index;
    private final Direction light;
    private final double turn;
    private final boolean squared;
    private final List<ReflectionPart> parts;
    // Light of each part, divided where energy is conserved.
    private final List<CieTable> lights = new ArrayList<>();
    private final List<MethodPlan> plans = new ArrayList<>();

    /**
     * A drawn map with its patch, light and settings.
     *
     * @param light direction towards the light
     * @param trial validation of the color tables, one for each part of the reflection; empty without tables
     */
    record Result(
            Patch patch,
            Direction light,
            Method method,
            String plan,
            String trial,
            double coherenceLength,
            LinearPicture picture) {}

    MaterialMap(DiffractionSetup setup, Choices choices, RefractiveIndex index, Direction light) {
        this.setup = setup;
        this.method = Methods.of(choices);
        this.index = index;
        this.light = light;
        this.turn = choices.get(ROTATE_PATCH);
        this.squared = FresnelFactor.of(choices) == FresnelFactor.SQUARED;
        this.parts = ReflectionPart.of(index, setup.cie());
        Direction inPatch = light.turned(-turn);
        Optional<EnergyDivisor> divisor =
                choices.get(ENERGY, Energy.SCALAR).divisor(setup.patch().heights(), index, choices);
        for (ReflectionPart part : parts) {
            CieTable divided =
                    divisor.map(found -> found.under(inPatch, part.cie())).orElse(part.cie());
            lights.add(divided);
            plans.add(method.plan(setup.surface().withLight(divided), VisibleRange.of(inPatch)));
        }
    }

    Method method() {
        return method;
    }

    MethodPlan plan() {
        return plans.get(0);
    }

    /** Returns the reference for a material without dispersion. */
    ExactLight exact() {
        return setup.withLight(lights.get(0)).exact(method);
    }

    /** Returns the reflectance relative to the standard material's, for a material without dispersion. */
    double overStandard(DirectionPair pair) {
        return parts.get(0).overStandard(pair);
    }

    Result draw(RenderContext context, int size) {
        DiscDirections directions = new DiscDirections(size, light);
        float[] sum = new float[3 * size * size];
        double sigma = 0;
        List<String> trials = new ArrayList<>();
        for (int p = 0; p < parts.size(); p++) {
            ShaderTables made = setup.tables(plans.get(p), MethodUse.COLOR, GpuBaker::of);
            if (!made.trial().isEmpty()) {
                trials.add(made.trial());
            }
            try (UploadedTables tables = UploadedTables.upload(context, made);
                    BrdfMapRenderer renderer = new BrdfMapRenderer(context, tables, size, turn);
                    Progress progress = setup.progress().start("BRDF map", (long) size * size)) {
                add(renderer.render(light, progress::step), parts.get(p), directions, sum);
                sigma = tables.windowSigma();
            }
        }
        return new Result(
                setup.patch(),
                light,
                method,
                plan().summary(),
                String.join("; ", trials),
                4 * sigma,
                new LinearPicture(size, size, sum));
    }

    private void add(LinearPicture map, ReflectionPart part, DiscDirections directions, float[] sum) {
        for (int pixel = 0; pixel < sum.length / 3; pixel++) {
            // The standard material's map stays as drawn, to the last bit.
            boolean scaled = map.covered(pixel) && !index.isStandard();
            double once = scaled ? part.overStandard(directions.at(pixel)) : 1;
            double factor = squared ? once * once : once;
            for (int c = 3 * pixel; c < 3 * pixel + 3; c++) {
                sum[c] += (float) (factor * map.xyz()[c]);
            }
        }
    }
}
