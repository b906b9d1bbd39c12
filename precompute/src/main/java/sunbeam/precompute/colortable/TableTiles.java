package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.VisibleRange;

/**
 * Where the texels of a table lie: a grid over a space, of which only those tiles exist that somebody looks at, and of these
 * only the texels that are needed are evaluated.
 *
 * @param space what the grid lies over
 * @param design its step and its slices
 * @param originX x of the grid's texel (0, 0)
 * @param originY y of it
 * @param side texels along a tile's side between which look-ups of its own fall
 * @param columns tiles along x that the grid has room for
 * @param rows tiles along y
 * @param lookUps the look-ups of each tile that exists, by its number, row times columns + column; none where all of it is
 *     looked at
 */
public record TableTiles(
        TableSpace space,
        TableDesign design,
        double originX,
        double originY,
        int side,
        int columns,
        int rows,
        Map<Integer, List<LookUp>> lookUps) {
    /** Texels beyond its own that a tile has: one before, two behind, so that a cubic B-spline stays inside. */
    static final int BORDER = 3;

    /** Texels around those that are looked at that are evaluated too: of a step at their rim POLE^10 is left, 2e-6. */
    static final int MARGIN = 10;

    // Of a tile where single directions are looked at.
    private static final int SMALL_SIDE = 32;
    // Of a texel and of a slice: processor and card may see a place on different sides of an edge.
    private static final double ROUNDING = 0.02;

    /**
     * A look-up.
     *
     * @param x texel of the tile to its left; -1 at the edge to the next tile
     * @param y texel of the tile before it
     * @param slice the first of those that it is interpolated between
     */
    public record LookUp(int x, int y, int slice) {}

    /** Copies. */
    public TableTiles {
        lookUps = Map.copyOf(lookUps);
    }

    /** One tile with all that a light shows. */
    public static TableTiles of(TableDesign design, Direction light) {
        int reach = (int) Math.ceil(TableSpace.OneLight.HORIZON / design.step()) + 1;
        double origin = -reach * design.step();
        TableSpace space = new TableSpace.OneLight(light);
        return new TableTiles(space, design, origin, origin, 2 * reach + 1, 1, 1, Map.of(0, List.of()));
    }

    /** Tiles with what some pairs of directions look at; at least one is needed. */
    public static TableTiles of(TableDesign design, List<DirectionPair> pairs) {
        VisibleRange range = VisibleRange.of(pairs);
        double step = design.step();
        TableTiles empty = new TableTiles(
                new TableSpace.Free(),
                design,
                range.minimumU() - step,
                range.minimumV() - step,
                SMALL_SIDE,
                tilesAcross(range.maximumU() - range.minimumU(), step),
                tilesAcross(range.maximumV() - range.minimumV(), step),
                Map.of());
        Map<Integer, List<LookUp>> lookUps = new TreeMap<>();
        pairs.forEach(pair -> empty.add(lookUps, pair));
        return new TableTiles(
                empty.space, design, empty.originX, empty.originY, SMALL_SIDE, empty.columns, empty.rows, lookUps);
    }

    private static int tilesAcross(double length, double step) {
        return 1 + (int) Math.ceil((length / step + 2) / SMALL_SIDE);
    }

    /** Notes a look-up; on both tiles where it falls on their edge. */
    private void add(Map<Integer, List<LookUp>> all, DirectionPair pair) {
        double[] place = space.place(pair.u(), pair.v(), pair.w());
        double x = (place[0] - originX) / design.step();
        double y = (place[1] - originY) / design.step();
        for (int row = tile(y - ROUNDING); row <= tile(y + ROUNDING); row++) {
            for (int column = tile(x - ROUNDING); column <= tile(x + ROUNDING); column++) {
                List<LookUp> lookUps = all.computeIfAbsent(row * columns + column, number -> new ArrayList<>());
                int left = (int) Math.floor(x) - column * side;
                int above = (int) Math.floor(y) - row * side;
                int low = firstSlice(-pair.w() / design.sliceStep() - ROUNDING);
                int high = firstSlice(-pair.w() / design.sliceStep() + ROUNDING);
                for (int slice = low; slice <= high; slice++) {
                    lookUps.add(new LookUp(left, above, slice));
                }
            }
        }
    }

    private int tile(double texel) {
        return (int) Math.floor(texel / side);
    }

    /** At both ends of the range all slices lie on one side. */
    private int firstSlice(double slice) {
        return Math.max(0, Math.min((int) Math.floor(slice) - 1, slices() - TableDesign.TAPS));
    }

    /** The numbers of the tiles that exist, in the order in which they are stored. */
    public List<Integer> numbers() {
        return lookUps.keySet().stream().sorted().toList();
    }

    /** Slices that a tile has. */
    public int slices() {
        return isOneLight() ? 1 : design.slices();
    }

    private boolean isOneLight() {
        return space instanceof TableSpace.OneLight;
    }

    /** Texels along a side of a tile as the shader has it. */
    public int storedSide() {
        return side + BORDER;
    }

    /** Texels along a side of the square that is evaluated for a tile. */
    int evaluatedSide() {
        return storedSide() + 2 * MARGIN;
    }

    /** Texels that are evaluated, of all tiles. */
    public long evaluated() {
        long count = 0;
        for (int number : numbers()) {
            for (int slice = 0; slice < slices(); slice++) {
                count += mask(number, slice).cardinality();
            }
        }
        return count;
    }

    /** Which texels of a tile's evaluated square are needed, row by row. */
    BitSet mask(int number, int slice) {
        BitSet mask = new BitSet();
        if (isOneLight()) {
            markDisc(mask);
        }
        for (LookUp look : lookUps.get(number)) {
            if (slice >= look.slice() && slice < look.slice() + TableDesign.TAPS) {
                markSquare(mask, look.x(), look.y());
            }
        }
        return mask;
    }

    /** The hemisphere of views, and beyond the horizon the spline's own reach and the margin. */
    private void markDisc(BitSet mask) {
        int evaluated = evaluatedSide();
        double radius = TableSpace.OneLight.HORIZON / design.step() + 2 + MARGIN;
        double middle = 0.5 * (side - 1) + 1 + MARGIN;
        for (int row = 0; row < evaluated; row++) {
            double squared = radius * radius - (row - middle) * (row - middle);
            if (squared >= 0) {
                int from = (int) Math.max(0, Math.ceil(middle - Math.sqrt(squared)));
                int to = (int) Math.min(evaluated - 1.0, Math.floor(middle + Math.sqrt(squared)));
                mask.set(row * evaluated + from, row * evaluated + to + 1);
            }
        }
    }

    /** Four by four texels around a look-up, the margin, and one more on each side for rounding. */
    private void markSquare(BitSet mask, int x, int y) {
        int evaluated = evaluatedSide();
        // The tile's texel x lies MARGIN + 1 texels into the evaluated square.
        int left = Math.max(0, x - 1);
        int right = Math.min(evaluated - 1, x + 2 * MARGIN + BORDER + 1);
        int bottom = Math.min(evaluated - 1, y + 2 * MARGIN + BORDER + 1);
        for (int row = Math.max(0, y - 1); row <= bottom; row++) {
            mask.set(row * evaluated + left, row * evaluated + right + 1);
        }
    }

    /** (u, v, w) of a texel of a tile's evaluated square. */
    double[] uvw(int number, int slice, int index) {
        int evaluated = evaluatedSide();
        int tileRow = number / columns;
        int row = index / evaluated;
        double x = (double) (number % columns) * side + index % evaluated - 1 - MARGIN;
        double y = (double) tileRow * side + row - 1 - MARGIN;
        return space.uvw(originX + x * design.step(), originY + y * design.step(), slice * design.sliceStep());
    }

    /** A range in which all lie that are evaluated. */
    public VisibleRange range() {
        double margin = (MARGIN + BORDER) * design.step();
        if (space instanceof TableSpace.OneLight one) {
            VisibleRange seen = VisibleRange.of(one.light());
            double lowest = -one.uvw(TableSpace.OneLight.HORIZON + margin, 0, 0)[2];
            return new VisibleRange(
                    seen.minimumU(), seen.maximumU(), seen.minimumV(), seen.maximumV(), lowest, seen.maximumW());
        }
        int first = all().mapToInt(LookUp::slice).min().orElse(0);
        int last = all().mapToInt(LookUp::slice).max().orElse(0) + TableDesign.TAPS - 1;
        return new VisibleRange(
                originX - margin,
                originX + columns * side * design.step() + margin,
                originY - margin,
                originY + rows * side * design.step() + margin,
                // Finer slices (see ValidatedTable) may begin up to one of these farther away.
                Math.max(0, first - 1) * design.sliceStep(),
                Math.min(design.slices() - 1, last + 1) * design.sliceStep());
    }

    private Stream<LookUp> all() {
        return lookUps.values().stream().flatMap(List::stream);
    }

    /** All that determines which texels there are, as text. */
    public String key() {
        StringBuilder key = new StringBuilder(String.format(
                Locale.ROOT, "%s|%s|%s|%s|%d|%d|%d", space, design, originX, originY, side, columns, rows));
        for (int number : numbers()) {
            key.append('|').append(number).append(lookUps.get(number));
        }
        return key.toString();
    }
}
