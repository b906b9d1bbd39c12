package sunbeam.app.measure.performance;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import jrtr.GraphicsException;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.measure.benchmark.MapSamples;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.method.Variant;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.setting.SettingException;

/** Measures every method on one patch: the thesis's first, with which all are compared. */
final class MethodsExperiment {
    /** Seed of the views at which errors are measured. */
    static final long SEED = 3;

    private final Meter meter;
    private final Scale scale;
    private final DiffractionSetup setup;
    private final String name;
    private final MapSamples exact;
    private final List<Measured> rows = new ArrayList<>();
    private final List<String> remarks = new ArrayList<>();

    /** @param name of the patch in the report */
    MethodsExperiment(Meter meter, Scale scale, DiffractionSetup setup, String name) {
        this.name = name;
        this.meter = meter;
        this.scale = scale;
        this.setup = setup;
        this.exact = new MapSamples(setup, Meter.LIGHT, scale.views(), SEED);
    }

    /** Every method's error and time. */
    PatchFigures run() {
        for (var type : Methods.ALL) {
            if (type != TableMethod.TYPE) {
                for (Variant variant : type.variants(setup.surface())) {
                    add(variant.name(), variant.method(), variant.note());
                }
            }
        }
        for (Average average : Average.values()) {
            GaussianArea area = scale.area().with(average);
            for (double tolerance : scale.tolerances()) {
                String table = String.format(
                        Locale.ROOT,
                        "table, %s, tolerance %s",
                        average.name().toLowerCase(Locale.ROOT),
                        PerformancePage.power(tolerance));
                add(table, new TableMethod(tolerance, area), "");
            }
        }
        double finest = scale.tolerances().get(scale.tolerances().size() - 1);
        rows.addAll(new TaylorLookUp(setup, scale.area()).measure(meter, exact, finest));
        return new PatchFigures(name, rows, remarks);
    }

    private void add(String row, Method method, String note) {
        try {
            rows.add(meter.measure(setup, row, method, Optional.of(exact), note));
        } catch (GraphicsException | SettingException unmeasured) {
            remarks.add(row + " was not measured: " + unmeasured.getMessage());
        }
    }
}
