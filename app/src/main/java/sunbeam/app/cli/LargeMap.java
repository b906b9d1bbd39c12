package sunbeam.app.cli;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GridSampling;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Choice of method table for a large map, where it is faster than method full, at the same tolerance. */
final class LargeMap {
    /** Side in pixels from which a table is faster than interpolation of spectra; sums over single orders are faster still. */
    static final int LEAST_SIDE = 1024;

    /** A table misses the tolerance, which method full may keep: its map is not drawn. */
    static final class TableMissed extends CancellationException {
        private static final long serialVersionUID = 1;
    }

    private LargeMap() {}

    /** True if a map is large, and the user has chosen neither a method nor settings that method table lacks. */
    static boolean mayHaveTable(int size, Choices choices) {
        Choices others = choices.only(Methods.SETTINGS).without(MethodSettings.LIGHT);
        return size >= LEAST_SIDE
                && choices.get(MethodSettings.AVERAGE) == Average.ENSEMBLE
                && others.chosen().stream().allMatch(TableMethod.TYPE::has);
    }

    /**
     * Returns the choices with method table if method full would interpolate spectra, and a table has room in memory.
     *
     * @param light direction in the patch's frame
     */
    static Optional<Choices> byTable(DiffractionSetup setup, Choices choices, Direction light) {
        VisibleRange range = VisibleRange.of(light);
        if (!(FullMethod.of(choices).tablePlan(setup.surface(), range).sampling() instanceof GridSampling)) {
            return Optional.empty();
        }
        Choices byTable = choices.with(Methods.METHOD, TableMethod.TYPE);
        try {
            Methods.of(byTable).plan(setup.surface(), range);
            return Optional.of(byTable);
        } catch (SettingException tooLarge) {
            return Optional.empty();
        }
    }

    /** Returns a setup that throws {@link TableMissed} in place of a warning. */
    static DiffractionSetup strict(DiffractionSetup setup) {
        return setup.withShortfall(shortfall -> {
            throw new TableMissed();
        });
    }
}
