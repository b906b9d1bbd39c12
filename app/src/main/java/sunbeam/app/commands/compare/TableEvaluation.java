package sunbeam.app.commands.compare;

import static sunbeam.app.scene.SceneSettings.INDEX;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.patch.PatchSettings.PATCH;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.commands.reflectance.Evaluator;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.files.input.IndexFile;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.gpu.colors.GpuColors;
import sunbeam.app.scene.SkinIndex;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.shader.MethodUse;

/** Computes what a table measured: X, Y, Z of rho, or the BRDF at each wavelength. */
record TableEvaluation(Choices choices, Environment environment, PrintWriter err) {
    private static final int BRDF = 3;

    /**
     * Refuses what is chosen of scenes, or names the patch again.
     *
     * @throws sunbeam.precompute.setting.SettingException for a setting that tables have nothing of
     */
    TableEvaluation {
        List<Setting<?>> known = new ArrayList<>(PatchSettings.ALL);
        known.remove(PATCH);
        known.addAll(Methods.SETTINGS);
        known.addAll(List.of(INDEX, ROTATE_PATCH));
        for (Setting<?> setting : choices.chosen()) {
            if (!known.contains(setting)) {
                throw choices.complaint(
                        setting, "has no place beside a table, which is compared with PATCH alone; leave it out");
            }
        }
    }

    CieTable cie() {
        return LightTable.of(choices);
    }

    /** The values of each of the table's rows, without a factor. */
    List<double[]> evaluate(MeasuredTable table, String patch) {
        if (!table.isOfColors() && choices.has(METHOD) && choices.get(METHOD).equals(TableMethod.TYPE)) {
            throw DiffractionSetup.withoutPower();
        }
        RefractiveIndex index = index(table);
        DirectionList list = table.queries().seenByTurned(choices.get(ROTATE_PATCH));
        PatchRequest request = new PatchRequest(choices.with(PATCH, patch));
        DiffractionSetup setup = new DiffractionSetup(
                        PatchLoader.load(request.raw(Preset.isThesis(choices))), environment, err)
                .lit(cie());
        List<double[]> results = evaluate(new Evaluator(list), index, setup);
        if (table.isOfColors()) {
            return results.stream()
                    .map(row -> new double[] {row[3] * row[0], row[3] * row[1], row[3] * row[2]})
                    .toList();
        }
        int each = results.size() / table.values().size();
        return IntStream.range(0, table.values().size())
                .mapToObj(row -> results.subList(each * row, each * (row + 1)).stream()
                        .mapToDouble(result -> result[BRDF])
                        .toArray())
                .toList();
    }

    private List<double[]> evaluate(Evaluator evaluator, RefractiveIndex index, DiffractionSetup setup) {
        DirectionList list = evaluator.list();
        // What an instrument lights is many coherence areas.
        Choices seen = setup.seen(MethodOptions.averaged(choices.only(Methods.SETTINGS)), err);
        Method method = Methods.of(seen);
        if (method instanceof ReferenceMethod) {
            return evaluator.indexed(index, setup.cie(), evaluator.evaluate(setup.exact(method)));
        }
        MethodPlan plan = method.plan(setup.surface(), VisibleRange.of(list.pairs()));
        err.println("plan: " + plan.summary());
        MethodUse use = list.spectral() ? MethodUse.SPECTRAL : MethodUse.COLOR;
        return evaluator.indexed(index, setup.cie(), evaluator.evaluate(setup.tables(plan, use, GpuColors::of)));
    }

    private RefractiveIndex index(MeasuredTable table) {
        SkinIndex chosen = choices.get(INDEX);
        if (!chosen.isByWavelength()) {
            return chosen.constant().orElseThrow();
        }
        if (table.isOfColors()) {
            throw choices.complaint(INDEX, "by wavelength has no gain that is one number; give a number, or spectra");
        }
        return IndexFile.read(Path.of(chosen.file()));
    }
}
