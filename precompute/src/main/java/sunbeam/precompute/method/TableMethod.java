package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;
import static sunbeam.precompute.plan.MethodSettings.WINDOW_ORIGIN;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.precompute.colortable.LevelGrid;
import sunbeam.precompute.colortable.TableBaking;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.colortable.TableLevels;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.colortable.TableTiles;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.Reach;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.rays.RayColors;
import sunbeam.precompute.rays.RaySpectrum;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Colors of the power that {@link FullMethod} diffracts, tabulated over (u, v, w) beforehand: a few look-ups a pixel
 * (docs/color-tables.md).
 *
 * @param tolerance relative error of colors
 * @param area the window and its average
 */
public record TableMethod(double tolerance, GaussianArea area) implements Method {
    // Of the tolerance, what is tabulated may take; the rest is interpolation's.
    private static final double SOURCE_SHARE = 0.5;

    // An ensemble's error is a fifth of what a table may add, and grows with the fifth power of the step.
    private static final double COARSE = 1.3;

    /** Its name and settings. */
    public static final MethodType TYPE = new MethodType(
            "table",
            "colors of full, tabulated beforehand: the fastest where many pixels look into one table; for a single small map or a short list full is.",
            List.of(TOLERANCE, WINDOW_ORIGIN, COHERENCE_LENGTH, AVERAGE),
            TableMethod::of);

    public TableMethod {
        TOLERANCE.kind().check(tolerance);
    }

    private static TableMethod of(Choices choices) {
        return new TableMethod(choices.get(TOLERANCE), GaussianArea.of(choices));
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod exact(HeightMap map) {
        return new ReferenceMethod(area);
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        double depth = TableDesign.depth(surface.map());
        if (range.reach() instanceof Reach.Everything) {
            TableLevels levels = TableLevels.within(tolerance, area, depth, false);
            TableLevels.Level finest = levels.levels().get(0);
            // Of a table whose list of tiles fits, there may be room for the tiles of a picture; who draws it knows.
            ArrayLayout list = LevelGrid.of(finest).tileList(levels.levels().size());
            requireRoom(surface, finest.design(), MemoryNeed.of(list.bytes(), List.of(list)));
            return new LevelledTable(surface, levels, sourceTolerance());
        }
        // What is validated may begin coarse; zeros between coherent speckles leave no room for that.
        double coarse = area.average() == Average.COHERENT ? 1 : COARSE;
        TableDesign design = TableDesign.within(tolerance, area, depth).scaled(coarse);
        TableTiles tiles = tiles(design, range.reach());
        TableBaking baking = new TableBaking(tiles);
        requireRoom(surface, tiles);
        FullMethod full = new FullMethod(TableChoices.within(sourceTolerance()), area);
        return new Planned(surface, this, range.reach(), tiles, baking, full.plan(surface, tiles.range()));
    }

    private void requireRoom(Surface surface, TableTiles tiles) {
        requireRoom(surface, tiles.design(), new TableBaking(tiles).memory());
    }

    private double sourceTolerance() {
        return Math.max(ErrorBudget.FINEST, SOURCE_SHARE * tolerance);
    }

    private void requireRoom(Surface surface, TableDesign design, MemoryNeed need) {
        surface.planner().excess(need).ifPresent(excess -> {
            throw SettingException.of(
                    TOLERANCE,
                    tolerance,
                    String.format(
                            Locale.ROOT,
                            "and a table of colors in steps of %.2g in (u, v) %s; give a coarser ",
                            design.step(),
                            excess),
                    TOLERANCE,
                    ", a shorter ",
                    COHERENCE_LENGTH,
                    ", or ",
                    Methods.METHOD,
                    " full");
        });
    }

    private static TableTiles tiles(TableDesign design, Reach reach) {
        if (reach instanceof Reach.OneLight one) {
            return TableTiles.of(design, one.light());
        }
        if (reach instanceof Reach.Pairs some) {
            return TableTiles.of(design, some.pairs());
        }
        throw new IllegalArgumentException("tiles of " + reach);
    }

    /** Its tiles are the coarsest; where colors need it, they become finer as they are made. */
    private record Planned(
            Surface surface, TableMethod method, Reach reach, TableTiles tiles, TableBaking baking, MethodPlan source)
            implements MethodPlan {

        private String step() {
            return String.format(Locale.ROOT, "%.2g", tiles.design().step());
        }

        @Override
        public String summary() {
            return String.format(
                    Locale.ROOT,
                    "table to %s %%: %s, step at most %s in (u, v), %.2f million places and %.0f MB or more; made of %s",
                    Plan.percent(method.tolerance),
                    tiles.slices() == 1 ? "one light" : tiles.slices() + " slices in w",
                    step(),
                    tiles.evaluated() * 1e-6,
                    baking.texelsLayout().bytes() * 1e-6,
                    source.summary());
        }

        @Override
        public List<String> reasons() {
            List<String> reasons = new ArrayList<>();
            reasons.add(String.format(
                    Locale.ROOT,
                    "step %s in (u, v), or smaller where a trial of the table asks for it: cubic B-splines through square roots of X, Y, Z err by"
                            + " the tolerance (docs/color-tables.md)",
                    step()));
            reasons.add(
                    tiles.slices() == 1
                            ? "one slice: w follows from u and v under one light"
                            : String.format(
                                    Locale.ROOT, "%d slices in w, interpolated by cubic polynomials", tiles.slices()));
            reasons.add("evaluated by full for half of the tolerance:");
            reasons.addAll(source.reasons());
            return reasons;
        }

        @Override
        public List<Sentence> warnings() {
            return source.warnings();
        }

        @Override
        public List<Sentence> shortfalls() {
            return source.shortfalls();
        }

        @Override
        public MemoryNeed memory() {
            return baking.memory();
        }

        @Override
        public boolean answers(MethodUse use) {
            return use == MethodUse.COLOR;
        }

        @Override
        public String key(MethodUse use) {
            return String.join(
                    "|",
                    "tried table 4",
                    String.valueOf(method.tolerance),
                    Sha256.of(tiles.key()),
                    directions(),
                    source.key(use));
        }

        /** Finer tiles exist for what is looked at alone, and differ where coarse ones do not. */
        private String directions() {
            Sha256 hash = new Sha256();
            if (reach instanceof Reach.Pairs some) {
                ByteBuffer bytes = ByteBuffer.allocate(3 * Double.BYTES);
                for (DirectionPair pair : some.pairs()) {
                    bytes.clear();
                    hash.add(bytes.putDouble(pair.u())
                            .putDouble(pair.v())
                            .putDouble(pair.w())
                            .flip());
                }
            }
            return hash.hex();
        }

        @Override
        public ShaderTables tables(MethodUse use, TableSources sources) {
            ShaderTables.Builder tables = new ShaderTables.Builder("table");
            ValidatedTable made = ValidatedTable.make(
                    method.tolerance,
                    reach,
                    tiles.design(),
                    design -> TableMethod.tiles(design, reach),
                    source(use, sources),
                    finer -> surface.planner()
                            .excess(new TableBaking(finer).memory())
                            .isEmpty(),
                    finer -> method.requireRoom(surface, finer),
                    sources.told());
            tables.trial(made.trial()).array(made.texels()).array(made.baking().tileList());
            area(tables, made.tiles());
            return tables.define("COLOR_SLICES", made.tiles().slices())
                    .reals("colorOrigin", made.tiles().originX(), made.tiles().originY())
                    .reals("colorTexelsPerUnit", 1 / made.tiles().design().step())
                    .reals("colorTileSide", made.tiles().side())
                    .build(plan().window().sigmaMetres(), plan().specularReach());
        }

        private Plan plan() {
            return source.sums().orElseThrow();
        }

        /** What evaluates so many places: the ensemble's colors along rays, the coherent ones by the shader of full. */
        private ValidatedTable.Sources source(MethodUse use, TableSources sources) {
            if (method.area.average() == Average.COHERENT) {
                ShaderTables evaluated = source.tables(use, sources);
                return (design, places) -> sources.colors(evaluated, places);
            }
            HeightMap map = surface.map();
            Plan widened = RaySpectrum.widened(plan(), map.width(), map.height(), method.area.window());
            RaySpectrum spectrum =
                    new RaySpectrum(widened, sources.fourier(widened), method.sourceTolerance(), surface.cie());
            return (design, places) -> sources.shown(
                    done -> new RayColors(spectrum, method.area, design.step(), design.sliceStep(), true, done),
                    places);
        }

        private static void area(ShaderTables.Builder tables, TableTiles tiles) {
            if (tiles.space() instanceof TableSpace.OneLight one) {
                Direction light = one.light();
                tables.reals("colorLight", light.x(), light.y(), light.z());
            } else {
                tables.reals("colorSlicesPerUnit", 1 / tiles.design().sliceStep());
            }
        }
    }
}
