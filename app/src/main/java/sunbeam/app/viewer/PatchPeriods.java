package sunbeam.app.viewer;

import java.util.IdentityHashMap;
import java.util.Optional;
import sunbeam.app.viewer.model.Background;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.patch.Patch;

/** Periods of the loaded patches, searched in the background, which takes seconds for a scan. Used on the event thread only. */
final class PatchPeriods {
    // The patches of some scenes. Each holds its heights, so that the map must not grow.
    private static final int MOST = 8;

    private final Background searching = new Background("period");
    private final Viewer viewer;
    // Keys are compared by identity; a value is empty while its period is searched.
    private final IdentityHashMap<Patch, Optional<GratingPeriod>> periods = new IdentityHashMap<>();

    PatchPeriods(Viewer viewer) {
        this.viewer = viewer;
    }

    /** Returns a patch's period; empty until it is found. */
    Optional<GratingPeriod> find(Patch patch) {
        return periods.getOrDefault(patch, Optional.empty());
    }

    /** Starts the search of a patch's period, unless it has been; at the end the presenter shows it. */
    void search(Patch patch) {
        if (periods.containsKey(patch)) {
            return;
        }
        if (periods.size() >= MOST) {
            periods.clear();
        }
        periods.put(patch, Optional.empty());
        searching.run(
                () -> GratingPeriod.of(patch),
                period -> {
                    periods.put(patch, Optional.of(period));
                    viewer.presenter.showPeriod();
                },
                viewer.window.status::message);
    }

    void close() {
        searching.close();
    }
}
