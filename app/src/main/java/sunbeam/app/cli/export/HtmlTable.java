package sunbeam.app.cli.export;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.zip.Deflater;
import sunbeam.app.files.output.ExrFile;
import sunbeam.app.files.output.StreamContent;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.patch.Patch;

/**
 * A self-contained HTML page (page.html, WebGL 2): a map and a sphere under a light, or a scene; a verdict before, the scan and errors below.
 */
final class HtmlTable implements TableWriter {
    // Quantization step of the colors' logarithms to base 2, per unit of tolerance.
    private static final double OCTAVES_PER_TOLERANCE = 0.5;
    // Lower bound of the compressed bytes per texel that directions reach.
    private static final double LEAST_BYTES = 0.3;
    // Shaders, script and picture of the scan.
    private static final int PAGE_BYTES = 110_000;
    // Limit of texels, as the graphics cards of telephones hold.
    private static final long MOST_TEXELS = 1 << 24;
    // Halvings of a scene's table, for pixels that see many directions.
    private static final int DOUBLINGS = 3;

    private final double tolerance;
    private final Optional<PageScene> scene;
    // The last grid: its contents are needed several times, but compressed once. A writer's grids differ in level.
    private QuantizedGrid packed;

    /** @param scene what the page shows; empty for a map and a sphere */
    HtmlTable(double tolerance, Optional<PageScene> scene) {
        this.tolerance = tolerance;
        this.scene = scene;
    }

    @Override
    public long leastBytes(GridShape shape) {
        return shape.allTexels() > MOST_TEXELS
                ? Long.MAX_VALUE
                : (long) (LEAST_BYTES * shape.evaluated()) + sceneBytes();
    }

    @Override
    public long bytes(ColorGrid grid) {
        return PAGE_BYTES + 4L * packed(grid).packed().length / 3 + sceneBytes();
    }

    private long sceneBytes() {
        return scene.map(PageScene::bytes).orElse(0L);
    }

    @Override
    public GridShape fit(GridShape shape) {
        int multiple = 1 << doublings();
        return scene.isEmpty()
                ? shape
                : new GridShape(
                        shape.u().padded(multiple), shape.v().padded(multiple), shape.depth(), shape.largestAngle());
    }

    private int doublings() {
        return scene.isPresent() ? DOUBLINGS : 0;
    }

    @Override
    public ColorGrid asRead(ColorGrid grid) {
        return packed(grid).grid();
    }

    private QuantizedGrid packed(ColorGrid grid) {
        if (packed == null || !grid.level().equals(packed.grid().level())) {
            packed = QuantizedGrid.of(grid, OCTAVES_PER_TOLERANCE * tolerance);
        }
        return packed;
    }

    @Override
    public Output output(ColorGrid grid, GridBaker baker, TableMetadata metadata) {
        Map<String, Object> table = metadata.fields(
                "square roots of CIE X, Y, Z of diffracted power, of logarithms in equal steps",
                "square roots linear along u and v, their squares cubic along w");
        GridShape shape = grid.shape();
        Patch patch = metadata.setup().patch();
        table.put("columns", shape.u().count());
        table.put("rows", shape.v().count());
        table.put("slices", shape.depth().count());
        table.put("levels", 1 + doublings());
        table.put("octaves", OCTAVES_PER_TOLERANCE * tolerance);
        table.put("floor", QuantizedGrid.FLOOR);
        table.put("most", packed(grid).most());
        table.put("largest", Math.toDegrees(shape.largestAngle()));
        table.put("theta", metadata.theta());
        table.put("exposure", scene.map(PageScene::exposure).orElseGet(metadata::exposure));
        table.put("scanWidth", patch.scan().width());
        scene.ifPresent(shown -> table.put("scene", shown.fields()));
        Map<String, String> values = new LinkedHashMap<>();
        String verdict = html(Verdict.of(patch, GratingPeriod.of(patch), 0, 0).sentence());
        String title = html(scene.map(PageScene::title).orElse("").strip());
        values.put("WARNINGS", paragraphs(patch.warnings()));
        values.put("TABLE", metadata.blur());
        values.put("SCAN", ScanPicture.of(patch.scan()));
        // In a script element "</" would end the element.
        values.put("JSON", new ObjectMapper().valueToTree(table).toString().replace("<", "\\u003c"));
        values.put("SHADERS", shaders(metadata));
        values.put("DATA", Base64.getEncoder().encodeToString(packed(grid).packed()));
        values.put("SCENE", scene.map(PageScene::elements).orElse(""));
        // Last, since a title may hold the name of another value.
        values.put(
                "HEADING",
                title.isEmpty() ? "<h1>" + verdict + "</h1>" : "<h1>" + title + "</h1>\n<p>" + verdict + "</p>");
        values.put("TITLE", title.isEmpty() ? "Diffraction of " + html(patch.name()) : title);
        String page = ShaderText.fill(ShaderText.of("page.html", metadata, doublings()), values);
        return new Output(
                Map.of(".html", StreamContent.of(page)),
                scene.map(PageScene::notes).orElse(List.of()),
                metadata.errors().sums());
    }

    private String shaders(TableMetadata metadata) {
        String table = ShaderText.Language.GLSL.translate(ShaderText.of("sunbeam.glsl", metadata, doublings()));
        List<String> names = scene.isEmpty()
                ? List.of("fullscreen.vert", "disc")
                : List.of("fullscreen.vert", "mesh.vert", "skin", "samples", "ground", "shadow");
        return names.stream()
                .map(name -> "<script type=\"text/plain\" id=\"" + name + "\">" + EmbeddedShaders.text(name, table)
                        + "</script>\n")
                .collect(Collectors.joining());
    }

    private static String paragraphs(List<String> warnings) {
        return warnings.stream()
                .map(warning -> "<p class=\"warning\">" + html("Warning: " + warning) + "</p>\n")
                .collect(Collectors.joining());
    }

    private static String html(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    /**
     * A compressed grid, which page.html decompresses. Logarithms of Y, X / Y and Z / Y are rounded to equal steps, {@code most} at most.
     * Their differences from a prediction by the neighbors and the slice before are split into low and high bytes, and deflated in zlib's
     * format.
     */
    private record QuantizedGrid(ColorGrid grid, byte[] packed, int most) {
        /** Power that is added to each color before its logarithm is taken, so that much darker colors become 0. */
        static final double FLOOR = 1e-10;

        private static final int CHANNELS = ColorGrid.CHANNELS;

        /** @param octaves quantization step of the logarithm to base 2 */
        static QuantizedGrid of(ColorGrid grid, double octaves) {
            GridShape shape = grid.shape();
            int columns = shape.u().count();
            int texels = shape.texels();
            int all = Math.toIntExact(shape.allTexels());
            byte[] codes = new byte[2 * CHANNELS * all];
            ColorGrid rounded = ColorGrid.empty(grid.level(), shape);
            int[][] before = new int[CHANNELS][texels];
            int[] steps = new int[CHANNELS];
            int most = 0;
            for (int slice = 0; slice < shape.depth().count(); slice++) {
                int[][] now = new int[CHANNELS][texels];
                for (int texel = 0; texel < texels; texel++) {
                    int column = texel % columns;
                    boolean seen = slice < shape.slicesAt(texel);
                    for (int c = 0; c < CHANNELS; c++) {
                        double root = grid.roots()[slice][CHANNELS * texel + c];
                        double color = grid.level().scale() * (root * root);
                        steps[c] = (int) Math.round(Math.log1p(color / FLOOR) / Math.log(2) / octaves);
                    }
                    for (int c = 0; c < CHANNELS; c++) {
                        int guess = before[c][texel] + guess(now[c], before[c], texel, column, columns);
                        // Channel 0 is Y, 1 and 2 are X and Z relative to it. Texels that no directions reach take the
                        // predicted value, whose difference is 0.
                        int wanted = c == 0 ? steps[1] : steps[c == 1 ? 0 : 2] - steps[1];
                        int rest = seen ? wanted - guess : 0;
                        int code = rest < 0 ? -2 * rest - 1 : 2 * rest;
                        now[c][texel] = guess + rest;
                        codes[2 * c * all + slice * texels + texel] = (byte) code;
                        codes[(2 * c + 1) * all + slice * texels + texel] = (byte) (code >> Byte.SIZE);
                    }
                    for (int c = 0; c < CHANNELS; c++) {
                        most = seen ? Math.max(most, steps[c]) : most;
                        double color = FLOOR * Math.expm1(steps[c] * octaves * Math.log(2));
                        rounded.roots()[slice][CHANNELS * texel + c] =
                                seen ? (float) Math.sqrt(color / grid.level().scale()) : 0;
                    }
                }
                before = now;
            }
            return new QuantizedGrid(rounded, ExrFile.deflated(codes, Deflater.BEST_COMPRESSION), most);
        }

        /** Predicts a texel's change from that of the left and the lower neighbor and the corner (median predictor of JPEG-LS). */
        private static int guess(int[] now, int[] before, int texel, int column, int columns) {
            int left = column == 0 ? 0 : now[texel - 1] - before[texel - 1];
            int below = texel < columns ? 0 : now[texel - columns] - before[texel - columns];
            int corner = column == 0 || texel < columns ? 0 : now[texel - columns - 1] - before[texel - columns - 1];
            int low = Math.min(left, below);
            int high = Math.max(left, below);
            return corner >= high ? low : corner <= low ? high : left + below - corner;
        }
    }
}
