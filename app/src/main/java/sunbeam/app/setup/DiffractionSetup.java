package sunbeam.app.setup;

import java.io.PrintWriter;
import java.util.List;
import java.util.function.Consumer;
import sunbeam.app.cache.TableStore;
import sunbeam.app.cli.Environment;
import sunbeam.app.cli.Messages;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;

/** A loaded patch and what follows from it: its plan for a range of directions, and its table from cache or anew. */
public final class DiffractionSetup {
    private final Patch patch;
    private final HeightLevels heights;
    private final PatchIdentity identity;
    private final CieTable cie = CieTable.load();
    private final TableStore store;

    /** Loads the patch and says what the user should know of it. */
    public DiffractionSetup(PatchOptions options, Environment environment, PrintWriter err) {
        this(options.load(), environment, err);
    }

    /** Takes a loaded patch and says what the user should know of it. */
    public DiffractionSetup(Patch patch, Environment environment, PrintWriter err) {
        this(patch, environment, warning -> {
            err.println(Messages.warning(warning));
            err.flush();
        });
        patch.warnings().forEach(warning -> err.println(Messages.warning(patch.name() + ": " + warning)));
        err.flush();
    }

    /**
     * Takes a patch that is loaded already, whose warnings have been told.
     *
     * @param warning told in one line each what goes wrong with the cache
     */
    public DiffractionSetup(Patch patch, Environment environment, Consumer<String> warning) {
        this.patch = patch;
        this.heights = HeightLevels.of(patch.heights());
        this.identity = new PatchIdentity(
                patch.name(),
                patch.heights().columns(),
                patch.heights().rows(),
                patch.heights().pitchX(),
                patch.heights().pitchY(),
                patch.digest());
        this.store = new TableStore(environment, warning);
    }

    public Patch patch() {
        return patch;
    }

    /** The patch's distinct heights. */
    public HeightLevels heights() {
        return heights;
    }

    /** Which surface the patch's tables belong to. */
    public PatchIdentity identity() {
        return identity;
    }

    public CieTable cie() {
        return cie;
    }

    /** Plans for the directions that can occur. */
    public Plan plan(PlanRequest request, VisibleRange range) {
        return new Planner(patch.heights(), heights, cie).plan(request, range);
    }

    /** Plans a method for the directions that can occur. */
    public Plan plan(Method method, VisibleRange range) {
        return plan(MethodBridge.planRequest(method), range);
    }

    /** What of a plan breaks its tolerance, one line each. */
    public List<Sentence> warnings(Plan plan) {
        return new Planner(patch.heights(), heights, cie).warnings(plan);
    }

    /** The table that a plan needs, made now. */
    public FourierTable freshTable(Plan plan) {
        return TableStore.build(identity, heights, plan);
    }

    /** The table that a plan needs, from the cache where it is there. */
    public FourierTable table(Plan plan) {
        return store.get(identity, heights, plan);
    }
}
